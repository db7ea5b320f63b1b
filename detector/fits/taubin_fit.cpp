#include "fits/taubin_fit.hpp"

#include "fit/closed_form/taubin.hpp"
#include "fits/normalise.hpp"
#include "fits/solvers.hpp"

namespace quadrille {

std::optional<Quadric> fit_taubin(const OrientedPointsd& points) {
  const auto normalised = normalise(points, 9, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const auto solution = solve_taubin(scatter_of_values(normalised->data), 0.0);
  if (!solution || !is_unique(solution->distances)) return std::nullopt;
  return normalised->undo(Quadric(solution->q));
}

}  // namespace quadrille
