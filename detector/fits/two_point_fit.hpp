#pragma once

#include <optional>

#include "fits/rounding.hpp"

namespace quadrille {

/// The quadric through two oriented points and three further positions, exact for unit normals:
///   f = f₀ − Σₖ f₀(xₖ) ∏_{j≠k} wⱼ / wⱼ(xₖ)   for k, j = 3, 4, 5,
/// with a member f₀ of the web of the two points (`make_web`) and wⱼ the plane through both of them
/// and xⱼ. Each summand is a pair of planes that meet in the line of the basis, where it vanishes
/// with its gradient, and holds two of the three positions: Lagrange's interpolation for
/// λ₁p² + λ₂pq + λ₃q², the paper's equation 7 without a decomposition. Two oriented points are six
/// constraints, of which the common line makes none dependent, and three positions the other three.
///
/// Degenerate, with nothing returned, are: two positions in one plane with the basis; a position on
/// its line; both oriented points on one ruling or one plane, which leaves the ratio of their
/// gradients free; normals to different sides. Conditioning: the error grows as |x₂ − x₁| / |b₁₂|
/// and as 1 / sin of the angles between the planes wⱼ, squared; if it is to exceed 3e-10 of the
/// points' radius nothing is returned.
/// @param points  five or more; of the third to fifth the positions alone are used. Any lengths of
///                normals
/// @return |q| = 1 with its gradient on the side of the normals; nullopt as said
/// @throws std::invalid_argument if the numbers of points and normals differ
std::optional<MinimalFit> fit_two_points(const OrientedPointsd& points);

}  // namespace quadrille
