#include "fit/closed_form/taubin.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "fit/closed_form/point_sums.hpp"

namespace quadrille {
namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Vector9d = Eigen::Matrix<double, 9, 1>;

// Steps of the inverse iteration. Each multiplies the error by the ratio of the two least
// distances, which is small wherever the points determine the quadric.
constexpr int kIterations = 5;
// Shift of all distances, as a share of their mean, so that the scatter is positive definite.
constexpr double kShift = 1e-7;

/// The equations S q = d G q in all but the constant coefficient, which follows from the others.
struct Reduced {
  Matrix9d scatter, weight;

  Reduced(const Matrix10d& S, double ridge)
      : scatter(S.topLeftCorner<9, 9>() -
                S.topRightCorner<9, 1>() * S.bottomLeftCorner<1, 9>() / S(9, 9)),
        weight(scatter_of_gradients(S).topLeftCorner<9, 9>()) {
    // The weight is singular only in the constant coefficient.
    weight.diagonal().array() += ridge * weight.trace();
  }
};

/// Completes a solution by the constant coefficient.
Vector10d completed(const Vector9d& q, const Matrix10d& S) {
  Vector10d all;
  all << q, -S.bottomLeftCorner<1, 9>().dot(q) / S(9, 9);
  return all;
}

}  // namespace

Matrix10d scatter_of_values(const OrientedPointsd& p) {
  const auto x = p.x(), y = p.y(), z = p.z();
  Eigen::Matrix<double, Eigen::Dynamic, 10> V(p.size(), 10);
  V << x.square().matrix(), y.square().matrix(), z.square().matrix(), (2.0 * x * y).matrix(),
      (2.0 * x * z).matrix(), (2.0 * y * z).matrix(), (2.0 * x).matrix(), (2.0 * y).matrix(),
      (2.0 * z).matrix(), Eigen::VectorXd::Ones(p.size());
  return products_of_columns(V);
}

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
  const Reduced reduced(S, ridge);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix9d> eigen(reduced.scatter, reduced.weight);
  if (eigen.info() != Eigen::Success) return std::nullopt;
  TaubinSolution solution;
  solution.distances = eigen.eigenvalues();
  solution.q = completed(eigen.eigenvectors().col(0), S);
  if (!solution.q.allFinite()) return std::nullopt;
  return solution;
}

std::optional<Vector10d> least_taubin(const Matrix10d& S, double ridge) {
  Reduced reduced(S, ridge);
  const double mean = reduced.scatter.trace() / reduced.weight.trace();
  reduced.scatter += kShift * mean * reduced.weight;
  // Rounding may have made the scatter of exact points indefinite.
  const Eigen::LLT<Matrix9d> positive(reduced.scatter);
  const bool is_positive = positive.info() == Eigen::Success;
  const Eigen::LDLT<Matrix9d> any = is_positive ? Eigen::LDLT<Matrix9d>() : reduced.scatter.ldlt();
  // An irregular start is orthogonal to no solution in practice.
  Vector9d q{{0.9, -0.6, 0.7, 0.3, -0.4, 0.5, 0.8, 0.2, -0.1}};
  for (int i = 0; i < kIterations; ++i) {
    const Vector9d along = reduced.weight * q;
    q = is_positive ? Vector9d(positive.solve(along)) : Vector9d(any.solve(along));
    q.normalize();
  }
  if (!(q.norm() > 0.0)) return std::nullopt;
  const Vector10d solution = completed(q, S);
  if (!solution.allFinite()) return std::nullopt;
  return solution;
}

}  // namespace quadrille
