#pragma once

#include <optional>

#include "fits/rounding.hpp"

namespace quadrille {

/// The quadric through three oriented points and a fourth position, exact for unit normals:
///   f = f₀ − f₀(x₄) / z(x₄)² z²   (paper, theorem 3),
/// where f₀ + λ z² is the pencil of the three points (`make_pencil`), with the lengths of their
/// gradients from αᵢ b_ij = αⱼ b_ji (`gradient_scales`). No decomposition is needed. The three
/// points are eight independent constraints, the fourth is the ninth. One of the three equations
/// for α is redundant; its violation is measured by `inconsistency` and not judged here.
///
/// Degenerate cases return nullopt: collinear points; a fourth point in the plane of the three; two
/// pairs of the three on rulings, or three points on one plane, or nearly so; normals on different
/// sides of any one quadric. The error grows as |xⱼ − xᵢ| / |b_ij| of the two better pairs, as
/// (size / z(x₄))², and with the flatness of the triangle; if its estimate exceeds
/// kMaxRoundingError, the result is nullopt too.
/// @param points  at least four, with normals of any length; only the position of the fourth is
///   used
/// @return |q| = 1 with its gradient on the side of the normals; nullopt in degenerate cases
/// @throws std::invalid_argument if the numbers of points and normals differ
std::optional<MinimalFit> fit_three_points(const OrientedPointsd& points);

}  // namespace quadrille
