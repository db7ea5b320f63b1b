#include "fit/closed_form/special_generals.hpp"

#include <cmath>

#include "base/symmetric_eigen.hpp"

namespace quadrille {
namespace {

/// The form λ₁x² + λ₂y² + 2 b·x + j in the frame of the eigenvectors, without the least eigenvalue,
/// whose axis is last.
struct PrincipalFrame {
  Eigen::Matrix3d R;
  Eigen::Vector3d b;
  double l1, l2, j;
};

PrincipalFrame principal_frame(const PosedQuadric& q) {
  const Eigen::Matrix4d Q = q.matrix();
  const Eigen::Matrix3d A = Q.topLeftCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(A);
  Eigen::Index least = 0;
  eigen.eigenvalues().cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d x = eigen.eigenvectors().col((least + 1) % 3);
  const Eigen::Vector3d y = eigen.eigenvectors().col((least + 2) % 3);
  PrincipalFrame f;
  f.R << x, y, x.cross(y);
  f.b = f.R.transpose() * Q.topRightCorner<3, 1>();
  f.l1 = eigen.eigenvalues()[(least + 1) % 3];
  f.l2 = eigen.eigenvalues()[(least + 2) % 3];
  f.j = Q(3, 3);
  return f;
}

}  // namespace

std::optional<PosedQuadric> nearest_parabolic(const PosedQuadric& general) {
  const PrincipalFrame f = principal_frame(general);
  // The vertex of λ₁x² + λ₂y² + 2 b·x + j = 0 is where f and its first two derivatives vanish.
  Eigen::Vector3d vertex(-f.b.x() / f.l1, -f.b.y() / f.l2, 0.0);
  vertex.z() = -0.5 * (f.j + f.b.x() * vertex.x() + f.b.y() * vertex.y()) / f.b.z();
  if (!vertex.allFinite() || vertex.norm() > 1e3) return std::nullopt;
  PosedQuadric parabolic;
  parabolic.X.linear() = f.R;
  parabolic.X.translation() = f.R * vertex;
  parabolic.D.diagonal() << f.l1 / f.b.z(), f.l2 / f.b.z(), 0, 0;
  parabolic.D(2, 3) = parabolic.D(3, 2) = 1.0;
  return parabolic;
}

std::optional<PosedQuadric> nearest_cylindrical(const PosedQuadric& general) {
  const PrincipalFrame f = principal_frame(general);
  const Eigen::Vector3d centre(-f.b.x() / f.l1, -f.b.y() / f.l2, 0.0);
  const double k = f.j + f.b.x() * centre.x() + f.b.y() * centre.y();
  if (!centre.allFinite() || centre.norm() > 1e3 || k == 0.0) return std::nullopt;
  PosedQuadric cylinder;
  cylinder.X.linear() = f.R;
  cylinder.X.translation() = f.R * centre;
  cylinder.D.diagonal() << -f.l1 / k, -f.l2 / k, 0, -1;
  return cylinder;
}

}  // namespace quadrille
