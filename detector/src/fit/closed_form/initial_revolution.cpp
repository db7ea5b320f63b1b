#include "fit/closed_form/initial_revolution.hpp"

#include <Eigen/Cholesky>

#include "fit/closed_form/axis_of_revolution.hpp"

namespace quadrille {
namespace {

// Keeps the foot of a cylinder's axis from drifting along the axis.
constexpr double kRidge = 1e-9;

}  // namespace

std::optional<PosedQuadric> initial_revolution(const PointMoments& moments) {
  const auto axis = axis_of_revolution(moments.normals.topLeftCorner<6, 6>(), kRidge);
  if (!axis) return std::nullopt;
  // The profile is ρ² = α + β s + γ s² with s = d·x and ρ² = |x|² − s² − 2 foot·x + |foot|², since
  // the foot is the point of the axis that is nearest to the origin.
  const Eigen::Vector3d d = axis->direction, zero = Eigen::Vector3d::Zero();
  const Eigen::Matrix3d none = Eigen::Matrix3d::Zero(), along = d * d.transpose();
  Eigen::Matrix<double, 10, 4> columns;
  columns << quadratic(none, zero, 1.0), quadratic(none, 0.5 * d, 0.0), quadratic(along, zero, 0.0),
      quadratic(Eigen::Matrix3d::Identity() - along, -axis->foot, 0.0);
  Eigen::Vector3d profile = least_squares(moments, columns);
  profile[0] += axis->foot.squaredNorm();
  if (!profile.allFinite()) return std::nullopt;
  PosedQuadric revolution;
  revolution.X = pose_along(axis->foot, axis->direction);
  revolution.D.diagonal() << 1, 1, -profile[2], -profile[0];
  revolution.D(2, 3) = revolution.D(3, 2) = -0.5 * profile[1];
  return revolution;
}

}  // namespace quadrille
