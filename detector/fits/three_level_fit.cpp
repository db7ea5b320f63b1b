#include "fits/three_level_fit.hpp"

#include "fit/closed_form/taubin.hpp"
#include "fits/normalise.hpp"
#include "fits/solvers.hpp"

namespace quadrille {

std::optional<Quadric> fit_three_level(const OrientedPointsd& points,
                                       const ThreeLevelOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const OrientedPointsd& data = normalised->data;
  Matrix10d S = Matrix10d::Zero();
  Vector10d b = Vector10d::Zero();
  for (const double level : {-options.offset, 0.0, options.offset}) {
    OrientedPointsd moved = data;
    moved.points += level * data.normals;
    const Matrix10d values = scatter_of_values(moved);
    S += values;
    // The last monomial is 1, so this column sums up all monomials.
    b += level * values.col(9);
  }
  const auto q = solve_normal_equations(S, b);
  if (!q) return std::nullopt;
  return normalised->undo(Quadric(Vector10d(*q)));
}

}  // namespace quadrille
