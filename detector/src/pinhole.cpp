#include <algorithm>
#include <cmath>

#include "quadrille/detector/depth_cells.hpp"

namespace quadrille {
namespace {

constexpr std::size_t kLeastPoints = 200;
// Widest field of view that one pinhole image can hold, as a tangent.
constexpr float kWidestTangent = 2.0f;
// No camera has more pixels, and an image that is emptier than this is none.
constexpr double kMostPixels = 64e6, kLeastFilled = 0.01;

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

/// Pixel pitch of a cloud in row order: the usual step between consecutive points of one row.
std::optional<float> pitch_from_order(const std::vector<Eigen::Vector4f>& uvw) {
  std::vector<float> steps;
  const std::size_t stride = std::max<std::size_t>(1, uvw.size() / 20000);
  std::size_t looked = 0;
  for (std::size_t i = 1; i < uvw.size(); i += stride, ++looked) {
    const Eigen::Vector2f d = (uvw[i] - uvw[i - 1]).head<2>().cwiseAbs();
    if (d.x() > 1e-5f && d.x() < 0.02f && d.y() < 0.05f * d.x()) steps.push_back(d.x());
  }
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
float pitch_from_density(const std::vector<Eigen::Vector4f>& uvw) {
  constexpr int kBlocks = 512;
  const float step = 2 * kWidestTangent / kBlocks;
  std::vector<int> histogram(kBlocks * kBlocks, 0);
  const auto bin = [&](float t) {
    return std::clamp(static_cast<int>((t + kWidestTangent) / step), 0, kBlocks - 1);
  };
  for (const Eigen::Vector4f& t : uvw) ++histogram[bin(t.y()) * kBlocks + bin(t.x())];
  std::vector<float> counts;
  for (const int n : histogram) {
    if (n > 0) counts.push_back(static_cast<float>(n));
  }
  return step / std::sqrt(std::max(1.0f, median(counts)));
}

/// Offset of the pixel centres within [0, 1) of a pixel, as a circular mean.
float phase_of(const std::vector<Eigen::Vector4f>& uvw, int axis, float pitch) {
  float c = 0, s = 0;
  const std::size_t stride = std::max<std::size_t>(1, uvw.size() / 5000);
  for (std::size_t i = 0; i < uvw.size(); i += stride) {
    const float pixels = uvw[i][axis] / pitch;
    const float a = static_cast<float>(2 * M_PI) * (pixels - std::floor(pixels));
    c += std::cos(a);
    s += std::sin(a);
  }
  const float turn = std::atan2(s, c) / static_cast<float>(2 * M_PI);
  return turn - std::floor(turn);
}

}  // namespace

std::optional<Projection> project(const PointCloud& cloud, int stride) {
  if (cloud.points.size() < kLeastPoints) return std::nullopt;
  const std::optional<Eigen::Isometry3f> X_VC = view_frame(cloud);
  if (!X_VC) return std::nullopt;
  Projection projection;
  projection.X_VC = *X_VC;
  const bool turned = !X_VC->matrix().isIdentity(0.0f);
  const std::size_t step = static_cast<std::size_t>(stride);
  projection.uvw.resize(cloud.points.size() / step + 1);
  std::size_t n = 0, unseen = 0;
  float low_u = kWidestTangent, high_u = -low_u, low_v = low_u, high_v = -low_u;
  for (std::size_t i = 0; i < cloud.points.size(); i += step) {
    const Eigen::Vector3f& p = cloud.points[i];
    const Eigen::Vector3f q = turned ? Eigen::Vector3f(*X_VC * p) : p;
    const float w = 1.0f / q.z();
    const float u = q.x() * w, v = q.y() * w;
    // Also false for NaN and for what is infinitely far.
    if (w > 0.0f && w < 1e4f && std::abs(u) < kWidestTangent && std::abs(v) < kWidestTangent) {
      projection.uvw[n++] = {u, v, w, 1.0f};
      low_u = std::min(low_u, u), high_u = std::max(high_u, u);
      low_v = std::min(low_v, v), high_v = std::max(high_v, v);
    } else {
      unseen += q.allFinite();
    }
  }
  projection.uvw.resize(n);
  projection.low = {low_u, low_v};
  projection.high = {high_u, high_v};
  const std::size_t seen = projection.uvw.size();
  if (seen < kLeastPoints || unseen > (seen + unseen) / 50) return std::nullopt;
  return projection;
}

std::optional<PinholeImage> find_image(const Projection& projection) {
  const std::vector<Eigen::Vector4f>& uvw = projection.uvw;
  const std::optional<float> ordered = pitch_from_order(uvw);
  PinholeImage image;
  image.pitch = ordered ? *ordered : pitch_from_density(uvw);
  // Pixel centres stand at half steps from the corner.
  const auto corner = [&](int axis) {
    const float phase = phase_of(uvw, axis, image.pitch) - 0.5f;
    return (std::floor(projection.low[axis] / image.pitch - phase) + phase) * image.pitch;
  };
  image.u0 = corner(0);
  image.v0 = corner(1);
  const double width = (projection.high.x() - image.u0) / image.pitch + 1.0;
  const double height = (projection.high.y() - image.v0) / image.pitch + 1.0;
  if (!(width * height < kMostPixels) ||
      static_cast<double>(uvw.size()) < kLeastFilled * width * height) {
    return std::nullopt;
  }
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  return image;
}

}  // namespace quadrille
