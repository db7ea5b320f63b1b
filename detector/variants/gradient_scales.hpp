#pragma once

#include <array>
#include <optional>

#include "search/basis.hpp"

namespace quadrille {

/// Computes the lengths α of a quadric's gradients at three of its points, up to a common factor,
/// from unit normals: αᵢ b_ij = αⱼ b_ji for each pair, where b_ij = nᵢ·(xⱼ − xᵢ) (paper, eq. 4
/// without q).
///
/// This holds because xᵢᵀQxⱼ in homogeneous coordinates is half of either side: the gradient at one
/// point, projected on the way to the other. Two of the equations determine α; the third then
/// measures the consistency of the basis, see `inconsistency`. For a pair on one ruling b_ij = b_ji
/// = 0, which determines nothing.
///
/// With softness s > 0, for noisy normals, α minimises
///   Σ (αᵢ b_ij − αⱼ b_ji)² / |xⱼ − xᵢ|² + s² Σ (αᵢ − 1)²;
/// pairs whose tangent planes see the other point at an angle below s keep the paper's common
/// scale. With s = 0, the two equations with the largest products are solved; relative errors ε of
/// the products become errors of about ε (|xⱼ − xᵢ| / |b_ij| + |xⱼ − xᵢ| / |b_ji|).
/// @return α with a mean of 1. Nullopt if points coincide; if α would not be positive, as for
///   normals that look to different sides; if s > 0 and one length is less than a tenth of another;
///   or if s = 0 and no two pairs have nonzero products (three points of a plane, or on rulings)
std::optional<std::array<double, 3>> gradient_scales(const std::array<OrientedPoint, 3>& basis,
                                                     double softness);

/// Softness for normals estimated from noisy points. If normals are off by 0.1 rad, 0.2 to 0.3
/// needs the fewest bases (experiment `basis`).
inline constexpr double kScaleSoftness = 0.2;

/// Makes the pencil of three points with unit normals: `make_pencil` with the lengths above.
/// @return nullopt if either has no result
std::optional<Pencil> make_scaled_pencil(const std::array<OrientedPoint, 3>& basis, double softness,
                                         double min_area_share = kMinAreaShare);

}  // namespace quadrille
