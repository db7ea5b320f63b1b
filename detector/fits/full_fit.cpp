#include "fits/full_fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "fits/scatter.hpp"
#include "fits/solvers.hpp"

namespace quadrille {
namespace {

/// The least eigenvalue θ(μ) of the reduced system, its vector, and whether it is unique.
struct Reduced {
  double theta;
  bool unique;
  Vector10d q;
};

Reduced reduce(const Matrix10d& S, const Matrix10d& BB, double w2, double mu) {
  const Eigen::SelfAdjointEigenSolver<Matrix10d> solver(Matrix10d(S - w2 * w2 / (w2 - mu) * BB));
  const auto& values = solver.eigenvalues();
  return {values[0], is_unique(values), solver.eigenvectors().col(0)};
}

}  // namespace

std::optional<FullFit> solve_full_system(const OrientedPointsd& points,
                                         const FullFitOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const OrientedPointsd& data = normalised->data;
  const double count = static_cast<double>(data.size());
  const double w2 = options.weight * options.weight;
  const Scatter scatter(data);
  const Matrix10d S = count * (scatter.values + w2 * scatter.gradients);
  const Matrix10d BB = count * scatter.along;
  double mu = 0.0;
  Reduced reduced = reduce(S, BB, w2, mu);
  if (!reduced.unique) return std::nullopt;
  for (int step = 0; step < 50; ++step) {
    const double pull = w2 / (w2 - mu);
    const double slope = -1.0 - pull * pull * reduced.q.dot(BB * reduced.q);
    const double next = std::clamp(mu - (reduced.theta - mu) / slope, 0.0, (1.0 - 1e-9) * w2);
    const bool converged = std::abs(next - mu) <= 1e-15 * w2;
    mu = next;
    reduced = reduce(S, BB, w2, mu);
    if (converged) break;
  }
  const auto Q = normalised->undo(Quadric(reduced.q));
  if (!Q) return std::nullopt;
  FullFit fit{*Q, Eigen::VectorXd(data.size())};
  for (Eigen::Index i = 0; i < data.size(); ++i) {
    const Eigen::Vector3d n = points.normals.col(i);
    fit.alpha[i] = w2 / (w2 - mu) * n.dot(Q->gradient(points.points.col(i))) / n.squaredNorm();
  }
  return fit;
}

std::optional<Quadric> fit_full(const OrientedPointsd& points, const FullFitOptions& options) {
  const auto fit = solve_full_system(points, options);
  if (!fit) return std::nullopt;
  return fit->Q;
}

}  // namespace quadrille
