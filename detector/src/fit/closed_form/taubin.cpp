#include "fit/closed_form/taubin.hpp"

#include <Eigen/Eigenvalues>

#include "fit/closed_form/point_sums.hpp"

namespace quadrille {

template <typename Scalar>
Matrix10d scatter_of_values(const OrientedPoints<Scalar>& p) {
  const auto x = p.x(), y = p.y(), z = p.z();
  const Scalar two(2);
  Eigen::Matrix<Scalar, Eigen::Dynamic, 10> V(p.size(), 10);
  V << x.square().matrix(), y.square().matrix(), z.square().matrix(), (two * x * y).matrix(),
      (two * x * z).matrix(), (two * y * z).matrix(), (two * x).matrix(), (two * y).matrix(),
      (two * z).matrix(), Eigen::Matrix<Scalar, Eigen::Dynamic, 1>::Ones(p.size());
  return products_of_columns(V);
}

template Matrix10d scatter_of_values(const OrientedPointsf&);
template Matrix10d scatter_of_values(const OrientedPointsd&);

Matrix10d scatter_of_gradients(const Matrix10d& S) {
  // ∇v is (2x, 0, 0) for x², (2y, 2x, 0) for 2xy, and (2, 0, 0) for 2x.
  const double xx = S(0, 9), yy = S(1, 9), zz = S(2, 9);
  const double xy = 0.5 * S(3, 9), xz = 0.5 * S(4, 9), yz = 0.5 * S(5, 9);
  const double x = 0.5 * S(6, 9), y = 0.5 * S(7, 9), z = 0.5 * S(8, 9);
  const double count = S(9, 9);
  Matrix10d G = Matrix10d::Zero();
  // clang-format off
  G.row(0).head<9>() << xx, 0, 0, xy, xz, 0, x, 0, 0;
  G.row(1).head<9>() << 0, yy, 0, xy, 0, yz, 0, y, 0;
  G.row(2).head<9>() << 0, 0, zz, 0, xz, yz, 0, 0, z;
  G.row(3).head<9>() << xy, xy, 0, xx + yy, yz, xz, y, x, 0;
  G.row(4).head<9>() << xz, 0, xz, yz, xx + zz, xy, z, 0, x;
  G.row(5).head<9>() << 0, yz, yz, xz, xy, yy + zz, 0, z, y;
  G.row(6).head<9>() << x, 0, 0, y, z, 0, count, 0, 0;
  G.row(7).head<9>() << 0, y, 0, x, 0, z, 0, count, 0;
  G.row(8).head<9>() << 0, 0, z, 0, x, y, 0, 0, count;
  // clang-format on
  return 4.0 * G;
}

std::optional<TaubinSolution> solve_taubin(const Matrix10d& S, double ridge) {
  using Matrix9d = Eigen::Matrix<double, 9, 9>;
  // The weight is singular only in the constant coefficient, which is eliminated from the scatter.
  const Matrix9d reduced =
      S.topLeftCorner<9, 9>() - S.topRightCorner<9, 1>() * S.bottomLeftCorner<1, 9>() / S(9, 9);
  Matrix9d weight = scatter_of_gradients(S).topLeftCorner<9, 9>();
  weight.diagonal().array() += ridge * weight.trace();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix9d> eigen(reduced, weight);
  if (eigen.info() != Eigen::Success) return std::nullopt;
  TaubinSolution solution;
  solution.distances = eigen.eigenvalues();
  solution.q.head<9>() = eigen.eigenvectors().col(0);
  solution.q[9] = -S.bottomLeftCorner<1, 9>().dot(solution.q.head<9>()) / S(9, 9);
  if (!solution.q.allFinite()) return std::nullopt;
  return solution;
}

}  // namespace quadrille
