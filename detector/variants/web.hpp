#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "search/basis.hpp"

namespace quadrille {

/// The quadrics through two oriented points, f = f₀ + λ₁p² + λ₂pq + λ₃q² (paper, eq. 6 for a
/// three-dimensional null space; figure 2b, spheroid).
///
/// Let p, q be two orthogonal planes through the line of the points, e = x₂ − x₁, and u₁ + u₂ = 1
/// the barycentric coordinates along the line. Then every quadric through the points is
///   f = c u₁u₂ + p (a₁u₁ + a₂u₂) + q (b₁u₁ + b₂u₂) + λ₁p² + λ₂pq + λ₃q².
/// The gradient at xᵢ is αᵢnᵢ for c = α₁ n₁·e = −α₂ n₂·e, aᵢ = αᵢ nᵢ·∇p, bᵢ = αᵢ nᵢ·∇q. Two
/// oriented points are seven independent constraints, which also determine the ratio of the scales
/// α.
struct Web {
  /// f₀ as a symmetric 4x4 matrix.
  Eigen::Matrix4d Q0;
  /// The planes p(x) = p · [x 1] and q(x) = q · [x 1], with unit normals.
  Eigen::Vector4d p, q;

  Eigen::Matrix4d at(const Eigen::Vector3d& lambda) const;
};

/// Makes the web of a basis by the closed form above.
/// @param softness  assumed error of the normals [rad]. If the products n·e are not larger than it,
///   the paper's common scale α₁ = α₂ = 1 is preferred to their noisy ratio; 0 for exact points
/// @return nullopt if the points coincide, or if no quadric has both normals on one side
std::optional<Web> make_web(const std::array<OrientedPoint, 2>& basis, double softness);

/// Assumed standard deviation of the direction of a noisy point's normal [rad], for make_web().
inline constexpr double kNormalNoise = 0.05;

/// The line λ = origin + s direction.
struct WebLine {
  Eigen::Vector3d origin, direction;
};

/// The quadrics of a web that pass through a further point with its tangent plane (paper, theorem
/// 3). Let planes p′, q′ be turned about the basis such that q′ contains the point. The point's
/// position determines λ₁′ and its tangent plane λ₂′; λ₃′ stays free, since q′² and its gradient
/// vanish at the point, which leaves a line.
///
/// The components of the gradient within q′ do not depend on λ₂′ and λ₃′; they determine the scale
/// of the normal and verify the point.
/// @param min_height  least distance of the point from the line of the basis, in the unit of the
///   points
/// @param min_cosine  least cosine between normal and gradient within the plane q′
/// @return nullopt if the point is too near or its normal disagrees
std::optional<WebLine> line_of(const Web& web, const OrientedPoint& point, double min_height,
                               double min_cosine);

}  // namespace quadrille
