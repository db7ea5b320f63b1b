#include "fits/solvers.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace quadrille {
namespace {

// Threshold for eigenvalues, which are squares in normal equations: 1e-13 corresponds to 3e-7 of
// the largest extent.
constexpr double kZero = 1e-13;
// Largest shift of a solution that rounding may cause, in extents of the points. Over the whole
// surface it grows by an order of magnitude, to half a millionth.
constexpr double kMaxShift = 5e-8;

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

}  // namespace

bool is_above_rounding(double eigenvalue, double largest) {
  return kMaxShift * eigenvalue > std::numeric_limits<double>::epsilon() * largest;
}

bool is_unique(const Eigen::VectorXd& ascending) {
  return ascending.size() == 1 || is_above_rounding(ascending[1], ascending[ascending.size() - 1]);
}

std::optional<Eigen::VectorXd> smallest_eigenvector(const Eigen::MatrixXd& S) {
  if (!S.allFinite()) return std::nullopt;
  const Solver solver(S);
  if (solver.info() != Eigen::Success || !is_unique(solver.eigenvalues())) return std::nullopt;
  return Eigen::VectorXd(solver.eigenvectors().col(0));
}

std::optional<Eigen::VectorXd> smallest_eigenvector(const Eigen::MatrixXd& S,
                                                    const Eigen::MatrixXd& G) {
  if (!S.allFinite() || !G.allFinite()) return std::nullopt;
  const Solver metric(G);
  if (metric.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd& g = metric.eigenvalues();
  const double largest = g[g.size() - 1];
  const Eigen::Index nulls = (g.array() <= kZero * largest).count();
  if (!(largest > 0) || nulls == g.size()) return std::nullopt;
  if (!is_above_rounding(g[nulls], largest)) return std::nullopt;
  // The new coordinates are the null space of G first, then directions of unit length in G.
  Eigen::MatrixXd T = metric.eigenvectors();
  for (Eigen::Index k = nulls; k < g.size(); ++k) T.col(k) /= std::sqrt(g[k]);
  const Eigen::MatrixXd M = T.transpose() * S * T;
  const Eigen::Index rest = g.size() - nulls;
  Eigen::MatrixXd reduced = M.bottomRightCorner(rest, rest);
  Eigen::MatrixXd eliminated(nulls, rest);
  if (nulls > 0) {
    const Eigen::MatrixXd corner = M.topLeftCorner(nulls, nulls);
    const Solver inner(corner);
    if (!(inner.eigenvalues()[0] > kZero * S.trace())) return std::nullopt;
    eliminated = -corner.ldlt().solve(M.topRightCorner(nulls, rest));
    reduced += M.bottomLeftCorner(rest, nulls) * eliminated;
  }
  const Solver solver(Eigen::MatrixXd(0.5 * (reduced + reduced.transpose())));
  if (solver.info() != Eigen::Success || !is_unique(solver.eigenvalues())) return std::nullopt;
  // Directions in which G is small are stretched, and the rounding of S with them.
  if (rest > 1 && !is_above_rounding(solver.eigenvalues()[1] * g[nulls], S.trace())) {
    return std::nullopt;
  }
  Eigen::VectorXd local(g.size());
  local.tail(rest) = solver.eigenvectors().col(0);
  if (nulls > 0) local.head(nulls) = eliminated * local.tail(rest);
  return Eigen::VectorXd(T * local);
}

std::optional<Eigen::VectorXd> solve_normal_equations(const Eigen::MatrixXd& S,
                                                      const Eigen::VectorXd& b) {
  if (!S.allFinite() || !b.allFinite()) return std::nullopt;
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(S);
  const Eigen::VectorXd pivots = ldlt.vectorD();
  if (!(pivots.minCoeff() > kZero * pivots.maxCoeff())) return std::nullopt;
  return Eigen::VectorXd(ldlt.solve(b));
}

}  // namespace quadrille
