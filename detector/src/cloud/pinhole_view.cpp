// Finds the direction in which a pinhole camera looks, and the points that it sees.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vector_clones.hpp"
#include "cloud/look_at.hpp"
#include "cloud/some_points.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/pinhole.hpp"

namespace quadrille {
namespace {

// A single view may leave one of this many finite points unseen, since stray points lie anywhere.
constexpr std::size_t kPointsPerUnseen = 50;
// The cloud's frame is taken for a camera's own frame if the cosine between its z axis and the mean
// ray is at least this (37°).
constexpr float kMinCosine = 0.8f;

/// Rotation that turns the mean viewing direction to z. It is the identity if z already serves, so
/// that the pixels of a depth camera stay aligned. Nullopt if there is no mean direction.
std::optional<Eigen::Isometry3f> view_frame(const CloudView& cloud) {
  const Eigen::Vector3f eye = cloud.viewpoint.cast<float>();
  const std::size_t stride = step_over(cloud.points.size());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t looked = 0, ahead = 0;
  for (std::size_t i = 0; i < cloud.points.size(); i += stride) {
    const Eigen::Vector3f ray = cloud.points[i] - eye;
    const float length = ray.norm();
    if (!(length > 0.0f && length < static_cast<float>(kMaxRange))) continue;
    ++looked;
    ahead += ray.z() > 0.0f;
    sum += (ray / length).cast<double>();
  }
  if (!(sum.norm() > 0.0)) return std::nullopt;
  const Eigen::Vector3f axis = sum.normalized().cast<float>();
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  if (ahead != looked || axis.z() < kMinCosine) {
    X_VC.linear() =
        Eigen::Quaternionf::FromTwoVectors(axis, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  }
  X_VC.translation() = X_VC.linear() * -eye;
  return X_VC;
}

/// Bounds of the tangents in separate vector lanes.
struct Bounds {
  std::array<float, SeenPoints::kSize> min_u, max_u, min_v, max_v;

  Bounds() {
    min_u.fill(PinholeView::kMaxTangent), min_v = min_u;
    max_u.fill(-PinholeView::kMaxTangent), max_v = max_u;
  }
  Eigen::AlignedBox2f joined() const {
    return {Eigen::Vector2f(*std::min_element(min_u.begin(), min_u.end()),
                            *std::min_element(min_v.begin(), min_v.end())),
            Eigen::Vector2f(*std::max_element(max_u.begin(), max_u.end()),
                            *std::max_element(max_v.begin(), max_v.end()))};
  }
};

/// Looks at kSize points from number `first` on, extends the bounds by the seen ones, and returns
/// their number.
QUADRILLE_VECTOR_CLONES
int widen(const PinholeView& view, std::span<const Eigen::Vector3f> points, std::size_t first,
          Bounds* bounds) {
  constexpr float kMax = PinholeView::kMaxTangent;
  const SeenPoints t = look_at(view, points, first);
  int n = 0;
  for (int k = 0; k < SeenPoints::kSize; ++k) {
    const bool seen = t.w[k] > 0.0f;
    const float low_u = seen ? t.u[k] : kMax, high_u = seen ? t.u[k] : -kMax;
    const float low_v = seen ? t.v[k] : kMax, high_v = seen ? t.v[k] : -kMax;
    n += seen;
    bounds->min_u[k] = low_u < bounds->min_u[k] ? low_u : bounds->min_u[k];
    bounds->max_u[k] = high_u > bounds->max_u[k] ? high_u : bounds->max_u[k];
    bounds->min_v[k] = low_v < bounds->min_v[k] ? low_v : bounds->min_v[k];
    bounds->max_v[k] = high_v > bounds->max_v[k] ? high_v : bounds->max_v[k];
  }
  return n;
}

/// Number of finite points among the kSize points from the k-th on.
int count_finite(const CloudView& cloud, const PinholeView& view, std::size_t k) {
  int n = 0;
  for (std::size_t i = k; i < k + SeenPoints::kSize; ++i) {
    const std::size_t at = i * static_cast<std::size_t>(view.stride);
    n += at < cloud.points.size() && cloud.points[at].allFinite();
  }
  return n;
}

}  // namespace

QUADRILLE_VECTOR_CLONES
SeenPoints PinholeView::look(std::span<const Eigen::Vector3f> points, std::size_t k) const {
  return look_at(*this, points, k);
}

std::optional<PinholeView> look_from_viewpoint(const CloudView& cloud, int stride) {
  const std::optional<Eigen::Isometry3f> X_VC = view_frame(cloud);
  if (!X_VC) return std::nullopt;
  PinholeView view;
  view.X_VC = *X_VC;
  view.stride = stride;
  Bounds bounds;
  for (std::size_t k = 0; k < view.looked_at(cloud.points.size()); k += SeenPoints::kSize) {
    const int n = widen(view, cloud.points, k, &bounds);
    view.seen += static_cast<std::size_t>(n);
    if (n < SeenPoints::kSize) {
      view.unseen += static_cast<std::size_t>(count_finite(cloud, view, k) - n);
    }
  }
  if (view.seen == 0) return std::nullopt;
  view.bounds = bounds.joined();
  return view;
}

std::optional<PinholeView> find_view(const CloudView& cloud, int stride) {
  if (cloud.points.size() < kMinPoints) return std::nullopt;
  std::optional<PinholeView> view = look_from_viewpoint(cloud, stride);
  if (!view || view->seen < kMinPoints) return std::nullopt;
  if (view->unseen > (view->seen + view->unseen) / kPointsPerUnseen) return std::nullopt;
  return view;
}

}  // namespace quadrille
