#pragma once

#include <optional>

#include "fits/rounding.hpp"

namespace quadrille {

/// The quadric through three oriented points and a fourth position, exact for unit normals:
///   f = f₀ − f₀(x₄) / z(x₄)² z²   (paper, theorem 3),
/// with the pencil f₀ + λ z² of the three points (`make_pencil`) and the lengths of their gradients
/// from αᵢ b_ij = αⱼ b_ji (`gradient_scales`). No decomposition is needed. The three points are
/// eight independent constraints, the fourth the ninth; that of the three equations for α one is
/// spare shows in `inconsistency`, and is not judged here.
///
/// Degenerate, with nothing returned, are: collinear points; a fourth in the plane of the three;
/// two pairs of the three on rulings, three on one plane, or nearly so; normals to different sides
/// of any one quadric. Conditioning: the error grows as |xⱼ − xᵢ| / |b_ij| of the two better pairs,
/// as (size / z(x₄))², and with the flatness of the triangle; if it is to exceed 3e-10 of the
/// points' radius nothing is returned.
/// @param points  four or more; of the fourth the position alone is used. Any lengths of normals
/// @return |q| = 1 with its gradient on the side of the normals; nullopt as said
/// @throws std::invalid_argument if the numbers of points and normals differ
std::optional<MinimalFit> fit_three_points(const OrientedPointsd& points);

}  // namespace quadrille
