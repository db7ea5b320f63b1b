#include "fit/closed_form/initial_plane.hpp"

#include "base/symmetric_eigen.hpp"

namespace quadrille {

std::optional<PosedQuadric> initial_plane(const PointMoments& moments) {
  const Eigen::Vector3d mean = moments.centre();
  const Eigen::Matrix3d S =
      moments.scatter() - static_cast<double>(moments.size) * mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(S);
  if (!(eigen.eigenvalues()[1] > 0)) return std::nullopt;
  PosedQuadric plane;
  plane.X = pose_along(mean, eigen.eigenvectors().col(0));
  plane.D(2, 3) = plane.D(3, 2) = 0.5;
  return plane;
}

}  // namespace quadrille
