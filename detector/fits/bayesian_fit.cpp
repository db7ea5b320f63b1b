#include "fits/bayesian_fit.hpp"

#include "fits/scatter.hpp"
#include "fits/solvers.hpp"

namespace quadrille {

std::optional<Quadric> fit_bayesian(const OrientedPointsd& points,
                                    const BayesianFitOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const Scatter scatter(normalised->data);
  const double count = static_cast<double>(points.size());
  const double precision = 1.0 / (options.prior_deviation * options.prior_deviation);
  Matrix10d S = count / (options.noise * options.noise) * scatter.values;
  // Off-diagonal entries of the symmetric matrix occur twice.
  S.diagonal().head<6>() += precision * Eigen::Vector<double, 6>{1, 1, 1, 2, 2, 2};
  Vector10d b = Vector10d::Zero();
  b.head<3>().setConstant(precision);
  const auto q = solve_normal_equations(S, b);
  if (!q) return std::nullopt;
  return normalised->undo(Quadric(Vector10d(*q)));
}

}  // namespace quadrille
