#pragma once

#include <array>
#include <optional>

#include "search/basis.hpp"

namespace quadrille {

/// Lengths α of a quadric's gradients at three of its points, up to a common factor, from unit
/// normals: αᵢ b_ij = αⱼ b_ji for each pair, with b_ij = nᵢ·(xⱼ − xᵢ) (paper, eq. 4 without q).
///
/// For xᵢᵀQxⱼ in homogeneous coordinates is half of either side: the gradient at one point, seen
/// along the way to the other. Two of the equations fix α; that the third holds, too, is the
/// condition that `inconsistency` measures. A pair on one ruling has b_ij = b_ji = 0 and tells
/// nothing.
///
/// With softness s > 0, for noisy normals, α minimises Σ (αᵢ b_ij − αⱼ b_ji)² / |xⱼ − xᵢ|² +
/// s² Σ (αᵢ − 1)²: of pairs that see each other under smaller angles than s the paper's common
/// scale is kept. With s = 0 the two equations with the largest products are solved; relative
/// errors ε of the products become errors of about ε (|xⱼ − xᵢ| / |b_ij| + |xⱼ − xᵢ| / |b_ji|).
/// @return α with a mean of 1; nullopt if points coincide, if α would not be positive, as of
/// normals
///         that look to different sides, if one length is but a tenth of another and s > 0, or if
///         s = 0 and no two pairs have products other than zero (three points of a plane, or on
///         rulings)
std::optional<std::array<double, 3>> gradient_scales(const std::array<OrientedPoint, 3>& basis,
                                                     double softness);

/// Softness for normals that are estimated from noisy points: with .2 to .3 the fewest bases are
/// needed where normals are off by .1 rad (experiment `basis`).
inline constexpr double kScaleSoftness = 0.2;

/// The basis with normals of the lengths α.
std::array<OrientedPoint, 3> with_lengths(std::array<OrientedPoint, 3> basis,
                                          const std::array<double, 3>& lengths);

/// The pencil of three points with unit normals: `make_pencil` of normals with the lengths above.
/// @return nullopt where either has none
std::optional<Pencil> make_scaled_pencil(const std::array<OrientedPoint, 3>& basis, double softness,
                                         double min_area_share = kMinAreaShare);

}  // namespace quadrille
