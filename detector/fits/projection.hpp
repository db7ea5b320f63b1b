#pragma once

#include <optional>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// The point of a quadric that is nearest to x, by orthogonal projection; the true distance is |x −
/// foot|.
///
/// In the eigenframe of the quadratic part, the feet of all normals through x are
///   yᵢ = (xᵢ − t bᵢ) / (1 + t λᵢ),
/// where t is a root of a polynomial of degree six. If a denominator vanishes (at centres, axes,
/// planes of symmetry), yᵢ is free and follows from the quadric itself. All feet are compared.
/// @return nullopt if the quadric has no real points, is zero or not finite, or if x is not finite
std::optional<Eigen::Vector3d> project(const Quadric& Q, const Eigen::Vector3d& x);

/// Projects by Newton's method from x itself, at a tenth of the cost of project(), for points whose
/// distance from the surface is small compared with its radii of curvature.
/// @return nullopt if the method does not converge
std::optional<Eigen::Vector3d> project_nearby(const Quadric& Q, const Eigen::Vector3d& x);

}  // namespace quadrille
