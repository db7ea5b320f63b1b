#pragma once

#include <optional>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// The point of a quadric that is closest to x: orthogonal projection, its true distance |x −
/// foot|.
///
/// In the eigenframe of the quadratic part the feet of all normals through x are
/// yᵢ = (xᵢ − t bᵢ) / (1 + t λᵢ), where t is a root of a polynomial of degree six; where a
/// denominator vanishes (centres, axes, planes of symmetry) yᵢ is free and the quadric itself gives
/// it. All feet are compared.
/// @return nullopt if the quadric has no real points, is zero or not finite, or if x is not finite
std::optional<Eigen::Vector3d> project(const Quadric& Q, const Eigen::Vector3d& x);

/// The same by Newton's method from x itself, a tenth of the cost: for points that are near to the
/// surface against its radii of curvature.
/// @return nullopt if the method does not converge
std::optional<Eigen::Vector3d> project_nearby(const Quadric& Q, const Eigen::Vector3d& x);

}  // namespace quadrille
