#include "fits/tangent_fit.hpp"

#include "fits/scatter.hpp"
#include "fits/solvers.hpp"

namespace quadrille {

std::optional<Quadric> fit_tangent(const OrientedPointsd& points,
                                   const TangentFitOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const Scatter scatter(normalised->data);
  const double w2 = options.weight * options.weight;
  const auto q = smallest_eigenvector(scatter.values + w2 * scatter.across(),
                                      Eigen::MatrixXd(scatter.gradients));
  if (!q) return std::nullopt;
  return normalised->undo(Quadric(Vector10d(*q)));
}

}  // namespace quadrille
