#include "space/support.hpp"

#include <algorithm>
#include <optional>

namespace quadrille {
namespace {

// Shorter planes are merely neighbours, such as boxes, books and lids [m].
constexpr double kMinSupportSize = 0.15;
// Least size of a support relative to the body: a plane that is no wider than the body is a part of
// it.
constexpr double kMinSupportToBody = 1.0;
// The plane reaches beyond its seen extent by this much: the body and its shadow cut off a part,
// and the plane goes on beyond the image [m].
constexpr double kBeyondSeen = 0.1;

// A body does not stand on a plane unless this share of its height lies above the plane: fitted
// feet may go into it. Things that lie flat are long, but not high.
constexpr double kMinShareAbove = 0.25;

/// Returns the plane if the target stands on it: a large plane with enough of the body above it,
/// and no farther from the body than the body is large (something in front may hide the body's
/// foot).
std::optional<SupportPlane> support(const Detection& plane, const Body& body) {
  if (!plane.X_CQ.matrix().allFinite() || !plane.X_CQ.linear().isUnitary(1e-3)) {
    return std::nullopt;
  }
  const double size = body.bounds_Q().sizes().maxCoeff();
  const double min_size = std::max(kMinSupportSize, kMinSupportToBody * size);
  if (plane.extent_Q.sizes().head<2>().minCoeff() < min_size) return std::nullopt;
  const Eigen::Vector2d beyond = Eigen::Vector2d::Constant(kBeyondSeen);
  const Eigen::AlignedBox2d seen(plane.extent_Q.min().head<2>(), plane.extent_Q.max().head<2>());
  const SupportPlane found{plane.X_CQ, {seen.min() - beyond, seen.max() + beyond}, seen, plane.rms};
  const Eigen::Vector3d middle_P = plane.X_CQ.inverse() * body.centre_C();
  if (!found.extent_P.contains(middle_P.head<2>())) return std::nullopt;
  const Eigen::Vector3d n_Q = body.X_CQ.linear().transpose() * found.n_C();
  const double reach = n_Q.cwiseAbs().dot(0.5 * body.bounds_Q().sizes());
  const double foot = middle_P.z() - reach, top = middle_P.z() + reach;
  if (foot > size || top < kMinShareAbove * (top - foot)) return std::nullopt;
  return found;
}

}  // namespace

std::vector<SupportPlane> supports_of(const Body& body, const std::vector<Detection>& detections) {
  std::vector<SupportPlane> planes;
  for (const Detection& d : detections) {
    if (d.type != QuadricType::kPlane) continue;
    if (const auto plane = support(d, body)) planes.push_back(*plane);
  }
  const Eigen::Vector3d middle = body.centre_C();
  std::stable_sort(planes.begin(), planes.end(), [&](const auto& a, const auto& b) {
    return a.distance(middle) < b.distance(middle);
  });
  return planes;
}

SupportPlane plane_of(const KnownSupport& support, const Eigen::Vector3d& near_C) {
  // Farther than any hand reaches [m].
  constexpr double kReach = 100.0;
  SupportPlane plane;
  plane.X_CP.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), support.n_C).toRotationMatrix();
  plane.X_CP.translation() = near_C - (support.n_C.dot(near_C) - support.offset) * support.n_C;
  plane.extent_P = {Eigen::Vector2d::Constant(-kReach), Eigen::Vector2d::Constant(kReach)};
  plane.seen_P = plane.extent_P;
  return plane;
}

}  // namespace quadrille
