#include "fits/gradient_one_fit.hpp"

#include "fits/scatter.hpp"
#include "fits/solvers.hpp"

namespace quadrille {

std::optional<Quadric> fit_gradient_one(const OrientedPointsd& points,
                                        const GradientOneOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace, NormalLengths::kAsGiven);
  if (!normalised) return std::nullopt;
  const Scatter scatter(normalised->data);
  Matrix10d S = scatter.values + options.gradient_weight * scatter.gradients;
  if (!solve_normal_equations(S, scatter.alignment)) return std::nullopt;
  const double ridge = options.ridge * scatter.values.topLeftCorner<3, 3>().trace() / 3.0;
  S.diagonal().head<6>() += ridge * Eigen::Vector<double, 6>{1, 1, 1, 2, 2, 2};
  const auto q = solve_normal_equations(S, options.gradient_weight * scatter.alignment);
  if (!q) return std::nullopt;
  return normalised->undo(Quadric(Vector10d(*q)));
}

}  // namespace quadrille
