#include "fits/compact_fit.hpp"

#include "fits/scatter.hpp"
#include "fits/solvers.hpp"

namespace quadrille {

std::optional<Quadric> fit_compact(const OrientedPointsd& points,
                                   const CompactFitOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace, NormalLengths::kAsGiven);
  if (!normalised) return std::nullopt;
  const Scatter scatter(normalised->data);
  const double w2 = options.weight * options.weight;
  const auto q =
      solve_normal_equations(scatter.values + w2 * scatter.gradients, w2 * scatter.alignment);
  if (!q) return std::nullopt;
  return normalised->undo(Quadric(Vector10d(*q)));
}

}  // namespace quadrille
