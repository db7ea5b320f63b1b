#pragma once

#include <optional>

#include "fits/rounding.hpp"

namespace quadrille {

/// The quadric through two oriented points and three further positions, exact for unit normals:
///   f = f₀ − Σₖ f₀(xₖ) ∏_{j≠k} wⱼ / wⱼ(xₖ)   for k, j = 3, 4, 5,
/// where f₀ is a member of the web of the two points (`make_web`) and wⱼ the plane through both of
/// them and xⱼ. Each summand is a pair of planes that meet in the line of the basis, where it
/// vanishes with its gradient, and contains two of the three positions. This is Lagrange's
/// interpolation for λ₁p² + λ₂pq + λ₃q², the paper's equation 7 without a decomposition. Two
/// oriented points are six constraints, which their common line leaves independent, and three
/// positions are the other three.
///
/// Degenerate cases return nullopt: two positions in one plane with the basis; a position on its
/// line; both oriented points on one ruling or one plane, which leaves the ratio of their gradients
/// undetermined; normals on different sides. The error grows as |x₂ − x₁| / |b₁₂| and as 1 / sin²
/// of the angles between the planes wⱼ; if its estimate exceeds kMaxRoundingError, the result is
/// nullopt too.
/// @param points  at least five, with normals of any length; only the positions of the third to
///   fifth are used
/// @return |q| = 1 with its gradient on the side of the normals; nullopt in degenerate cases
/// @throws std::invalid_argument if the numbers of points and normals differ
std::optional<MinimalFit> fit_two_points(const OrientedPointsd& points);

}  // namespace quadrille
