#include "quadrille/detector/pinhole.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

constexpr std::size_t kMinPoints = 200;
// No camera has more pixels, and an image that is emptier than this is none.
constexpr double kMaxPixels = 64e6, kMinFilled = 0.01;

/// Rotation that turns the mean viewing direction to z; the identity where z serves already, so
/// that the pixels of a depth camera stay aligned.
std::optional<Eigen::Isometry3f> view_frame(const PointCloud& cloud) {
  const Eigen::Vector3f eye = cloud.viewpoint.cast<float>();
  const std::size_t stride = std::max<std::size_t>(1, cloud.points.size() / 10000);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t looked = 0, ahead = 0;
  for (std::size_t i = 0; i < cloud.points.size(); i += stride) {
    const Eigen::Vector3f ray = cloud.points[i] - eye;
    const float length = ray.norm();
    if (!(length > 1e-6f && length < 1e6f)) continue;
    ++looked;
    ahead += ray.z() > 0.0f;
    sum += (ray / length).cast<double>();
  }
  if (looked == 0 || sum.norm() < 0.3 * static_cast<double>(looked)) return std::nullopt;
  const Eigen::Vector3f axis = sum.normalized().cast<float>();
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  if (ahead != looked || axis.z() < 0.8f) {
    X_VC.linear() =
        Eigen::Quaternionf::FromTwoVectors(axis, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  }
  X_VC.translation() = X_VC.linear() * -eye;
  return X_VC;
}

float median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Calls visit(t, next) for about so many of the points seen, evenly over the cloud: the point's
/// (u, v, w) and that of the next one seen.
template <class Visitor>
void sample_pairs(const PointCloud& cloud, const PinholeView& view, std::size_t about,
                  Visitor&& visit) {
  const std::size_t step = static_cast<std::size_t>(view.stride), size = cloud.points.size();
  const std::size_t stride = step * std::max<std::size_t>(1, size / step / about);
  for (std::size_t i = 0; i + step < size; i += stride) {
    const Eigen::Vector3f t = view(cloud.points[i]);
    if (t.z() == 0.0f) continue;
    for (std::size_t k = i + step; k < size; k += step) {
      const Eigen::Vector3f next = view(cloud.points[k]);
      if (next.z() == 0.0f) continue;
      visit(t, next);
      break;
    }
  }
}

/// Pixel pitch of a cloud in row order: the usual step between consecutive points of one row.
std::optional<float> pitch_from_order(const PointCloud& cloud, const PinholeView& view) {
  std::vector<float> steps;
  std::size_t looked = 0;
  sample_pairs(cloud, view, 10000, [&](const Eigen::Vector3f& t, const Eigen::Vector3f& next) {
    const Eigen::Vector2f d = (next - t).head<2>().cwiseAbs();
    if (d.x() > 1e-5f && d.x() < 0.02f && d.y() < 0.05f * d.x()) steps.push_back(d.x());
    ++looked;
  });
  if (steps.empty() || steps.size() < looked / 2) return std::nullopt;
  const float usual = median(steps);
  // The steps of one pixel, averaged, undo the rounding of single ones.
  double sum = 0;
  int n = 0;
  for (const float s : steps) {
    if (std::abs(s - usual) < 0.2f * usual) sum += s, ++n;
  }
  return static_cast<float>(sum / n);
}

/// Pixel pitch from the density of points over the part of the image that they cover.
float pitch_from_density(const PointCloud& cloud, const PinholeView& view) {
  constexpr int kBlocks = 512;
  constexpr float kReach = PinholeView::kWidestTangent, kStep = 2 * kReach / kBlocks;
  std::vector<int> histogram(kBlocks * kBlocks, 0);
  const auto bin = [&](float t) {
    return std::clamp(static_cast<int>((t + kReach) / kStep), 0, kBlocks - 1);
  };
  for (std::size_t i = 0; i < cloud.points.size(); i += static_cast<std::size_t>(view.stride)) {
    const Eigen::Vector3f t = view(cloud.points[i]);
    if (t.z() > 0.0f) ++histogram[bin(t.y()) * kBlocks + bin(t.x())];
  }
  std::vector<float> counts;
  for (const int n : histogram) {
    if (n > 0) counts.push_back(static_cast<float>(n));
  }
  return kStep / std::sqrt(std::max(1.0f, median(counts)));
}

/// Offsets of the pixel centres within [0, 1) of a pixel, as circular means.
Eigen::Array2f phase_of(const PointCloud& cloud, const PinholeView& view, float pitch) {
  Eigen::Array2f c = Eigen::Array2f::Zero(), s = Eigen::Array2f::Zero();
  sample_pairs(cloud, view, 2500, [&](const Eigen::Vector3f& t, const Eigen::Vector3f&) {
    const Eigen::Array2f a = static_cast<float>(2 * M_PI / pitch) * t.head<2>().array();
    c += a.cos();
    s += a.sin();
  });
  Eigen::Array2f phase;
  for (int axis = 0; axis < 2; ++axis) {
    const float turn = std::atan2(s[axis], c[axis]) / static_cast<float>(2 * M_PI);
    phase[axis] = turn - std::floor(turn);
  }
  return phase;
}

/// Least and greatest tangents, lane by lane.
struct Bounds {
  std::array<float, SeenPoints::kSize> low_u, high_u, low_v, high_v;

  Bounds() {
    low_u.fill(PinholeView::kWidestTangent), low_v = low_u;
    high_u.fill(-PinholeView::kWidestTangent), high_v = high_u;
  }
};

/// Takes the points that are seen into the bounds, and counts them.
QUADRILLE_VECTOR_CLONES
int widen(const SeenPoints& t, Bounds* bounds) {
  int n = 0;
  for (int k = 0; k < SeenPoints::kSize; ++k) {
    const bool seen = t.w[k] > 0.0f;
    n += seen;
    bounds->low_u[k] = std::min(bounds->low_u[k], seen ? t.u[k] : bounds->low_u[k]);
    bounds->high_u[k] = std::max(bounds->high_u[k], seen ? t.u[k] : bounds->high_u[k]);
    bounds->low_v[k] = std::min(bounds->low_v[k], seen ? t.v[k] : bounds->low_v[k]);
    bounds->high_v[k] = std::max(bounds->high_v[k], seen ? t.v[k] : bounds->high_v[k]);
  }
  return n;
}

/// Those of the kSize points from the k-th one on that are finite.
int count_finite(const PointCloud& cloud, const PinholeView& view, std::size_t k) {
  int n = 0;
  for (std::size_t i = k; i < k + SeenPoints::kSize; ++i) {
    const std::size_t at = i * static_cast<std::size_t>(view.stride);
    n += at < cloud.points.size() && cloud.points[at].allFinite();
  }
  return n;
}

}  // namespace

QUADRILLE_VECTOR_CLONES
SeenPoints PinholeView::look(const std::vector<Eigen::Vector3f>& points, std::size_t k) const {
  constexpr int kSize = SeenPoints::kSize;
  const std::size_t step = static_cast<std::size_t>(stride), first = k * step;
  std::array<float, kSize> x, y, z;
  if (step == 1 && first + kSize <= points.size()) {
    const float* p = points[first].data();
    for (int i = 0; i < kSize; ++i) x[i] = p[3 * i], y[i] = p[3 * i + 1], z[i] = p[3 * i + 2];
  } else {
    const Eigen::Vector3f missing =
        Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
    for (int i = 0; i < kSize; ++i) {
      const std::size_t at = first + static_cast<std::size_t>(i) * step;
      const Eigen::Vector3f& p = at < points.size() ? points[at] : missing;
      x[i] = p.x(), y[i] = p.y(), z[i] = p.z();
    }
  }
  SeenPoints seen;
  for (int i = 0; i < kSize; ++i) {
    const Eigen::Vector3f t = (*this)({x[i], y[i], z[i]});
    seen.u[i] = t.x(), seen.v[i] = t.y(), seen.w[i] = t.z();
  }
  return seen;
}

std::optional<PinholeView> find_view(const PointCloud& cloud, int stride) {
  if (cloud.points.size() < kMinPoints) return std::nullopt;
  const std::optional<Eigen::Isometry3f> X_VC = view_frame(cloud);
  if (!X_VC) return std::nullopt;
  PinholeView view;
  view.X_VC = *X_VC;
  view.stride = stride;
  Bounds bounds;
  std::size_t unseen = 0;
  for (std::size_t k = 0; k < view.looked_at(cloud.points.size()); k += SeenPoints::kSize) {
    const int n = widen(view.look(cloud.points, k), &bounds);
    view.seen += static_cast<std::size_t>(n);
    if (n < SeenPoints::kSize) {
      unseen += static_cast<std::size_t>(count_finite(cloud, view, k) - n);
    }
  }
  if (view.seen < kMinPoints || unseen > (view.seen + unseen) / 50) return std::nullopt;
  view.low = {*std::min_element(bounds.low_u.begin(), bounds.low_u.end()),
              *std::min_element(bounds.low_v.begin(), bounds.low_v.end())};
  view.high = {*std::max_element(bounds.high_u.begin(), bounds.high_u.end()),
               *std::max_element(bounds.high_v.begin(), bounds.high_v.end())};
  return view;
}

std::optional<PinholeImage> find_image(const PointCloud& cloud, const PinholeView& view) {
  const std::optional<float> ordered = pitch_from_order(cloud, view);
  PinholeImage image;
  image.pitch = ordered ? *ordered : pitch_from_density(cloud, view);
  // Pixel centres stand at half steps from the corner.
  const Eigen::Array2f phase = phase_of(cloud, view, image.pitch) - 0.5f;
  const Eigen::Array2f corner = ((view.low / image.pitch - phase).floor() + phase) * image.pitch;
  image.u0 = corner.x();
  image.v0 = corner.y();
  const Eigen::Array2d size = ((view.high - corner) / image.pitch + 1.0f).cast<double>();
  if (!(size.prod() < kMaxPixels) || static_cast<double>(view.seen) < kMinFilled * size.prod()) {
    return std::nullopt;
  }
  image.width = static_cast<int>(size.x());
  image.height = static_cast<int>(size.y());
  return image;
}

}  // namespace quadrille
