#include "fit/closed_form/initial_revolution.hpp"

#include "fit/closed_form/axis_of_revolution.hpp"
#include "fit/closed_form/point_sums.hpp"

namespace quadrille {
namespace {

// Keeps the foot of a cylinder's axis from drifting along the axis.
constexpr double kRidge = 1e-9;

}  // namespace

std::optional<PosedQuadric> initial_revolution(const OrientedPointsf& p) {
  const auto axis = axis_of_revolution(p, kRidge);
  if (!axis) return std::nullopt;
  // The profile is ρ² = α + β s + γ s².
  const Eigen::Isometry3d X = pose_along(axis->foot, axis->direction);
  const Eigen::Isometry3f Y = X.inverse().cast<float>();
  const auto local = [&](int r) {
    return Y(r, 0) * p.x() + Y(r, 1) * p.y() + Y(r, 2) * p.z() + Y(r, 3);
  };
  const Eigen::ArrayXf s = local(2);
  Eigen::Matrix<float, Eigen::Dynamic, 4> M(p.size(), 4);
  M << Eigen::VectorXf::Ones(p.size()), s.matrix(), s.square().matrix(),
      (local(0).square() + local(1).square()).matrix();
  const Eigen::Vector3d profile = least_squares(M);
  if (!profile.allFinite()) return std::nullopt;
  PosedQuadric revolution;
  revolution.X = X;
  revolution.D.diagonal() << 1, 1, -profile[2], -profile[0];
  revolution.D(2, 3) = revolution.D(3, 2) = -0.5 * profile[1];
  return revolution;
}

}  // namespace quadrille
