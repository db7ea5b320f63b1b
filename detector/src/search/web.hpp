#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "search/basis.hpp"

namespace quadrille {

/// The quadrics through two oriented points, f = f₀ + λ₁p² + λ₂pq + λ₃q² (paper, eq. 6, for a null
/// space of three dimensions; figure 2b, spheroid).
///
/// With p, q two orthogonal planes through the line of the points, e = x₂ − x₁, and u₁ + u₂ = 1 the
/// barycentric coordinates along it, every quadric through the points is
///   f = c u₁u₂ + p (a₁u₁ + a₂u₂) + q (b₁u₁ + b₂u₂) + λ₁p² + λ₂pq + λ₃q².
/// The gradient at xᵢ is αᵢnᵢ for c = α₁ n₁·e = −α₂ n₂·e, aᵢ = αᵢ nᵢ·∇p, bᵢ = αᵢ nᵢ·∇q: two
/// oriented points are seven independent constraints, and the ratio of the scales α is one of
/// their results.
struct Web {
  /// f₀ as a symmetric 4x4 matrix.
  Eigen::Matrix4d Q0;
  /// p(x) = p · [x 1], q likewise; unit normals.
  Eigen::Vector4d p, q;

  Eigen::Matrix4d at(const Eigen::Vector3d& lambda) const;
};

/// The web of a basis by the closed form above.
/// @param softness  how far normals [rad] are doubted: of it and less the paper's common scale
///                  α₁ = α₂ = 1 is preferred to the ratio of noisy products n·e; 0 for exact points
/// @return nullopt if the points coincide, or if no quadric has these normals on one side
std::optional<Web> make_web(const std::array<OrientedPoint, 2>& basis, double softness);

/// λ = origin + s direction.
struct WebLine {
  Eigen::Vector3d origin, direction;
};

/// The quadrics of a web through a further point with its tangent plane (paper, theorem 3): in
/// planes p′, q′ turned about the basis so that q′ holds the point, its position gives λ₁′ and its
/// tangent plane λ₂′. λ₃′ stays free, as q′² and its gradient vanish at the point: a line.
///
/// The components of the gradient within q′ do not depend on λ₂′ and λ₃′; they tell the scale of
/// the normal, and verify the point.
/// @param min_height  of the point over the basis's line, in units of the points
/// @param min_cosine  between normal and gradient within the plane q′
/// @return nullopt if the point is too near or has a foreign normal
std::optional<WebLine> line_of(const Web& web, const OrientedPoint& point, double min_height,
                               double min_cosine);

}  // namespace quadrille
