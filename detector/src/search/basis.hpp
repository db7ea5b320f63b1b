#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "fit/oriented_point.hpp"

namespace quadrille {

/// The pencil of quadrics through three oriented points, f = f₀ + λ z² (paper, theorems 1 and 3).
///
/// With m the unit normal of the points' plane, z = m·(x − x₁), and uᵢ the barycentric coordinates
/// of the projection into that plane, every quadric through the points is
///   f = c₁₂u₁u₂ + c₂₃u₂u₃ + c₃₁u₃u₁ + z (l₁u₁ + l₂u₂ + l₃u₃) + λ z².
/// The gradient at xᵢ is nᵢ for c_ij = nᵢ·(x_j − xᵢ) and lᵢ = nᵢ·m. The lengths of the normals
/// count: unit normals are the paper's common scale, which is exact on spheres and circular
/// cylinders alone; `gradient_scales` has the true ones. λ alone stays free: z² is the data plane
/// squared, the trivial solution of theorem 1.
struct Pencil {
  /// f₀ as a symmetric 4x4 matrix.
  Eigen::Matrix4d Q0;
  /// The data plane (m, −m·x₁): z(x) = plane · [x 1].
  Eigen::Vector4d plane;

  /// Q₀ + λ plane planeᵀ.
  Eigen::Matrix4d at(double lambda) const { return Q0 + lambda * plane * plane.transpose(); }
};

/// How far three oriented points are from lying on one quadric, 0 to 1: they do exactly when
/// b₁₂b₂₃b₃₁ = b₂₁b₃₂b₁₃ with b_ij = nᵢ·(x_j − xᵢ) and b_ij, b_ji of one sign.
double inconsistency(const std::array<OrientedPoint, 3>& basis);

/// Least area of a noisy basis's triangle, twice, over the square of its longest side: of flatter
/// ones the plane is chance.
inline constexpr double kMinAreaShare = 0.05;

/// The pencil of a basis by the closed form above.
/// @param basis  with normals of the lengths of the gradients
/// @return nullopt if the points are (nearly) collinear or coincide
std::optional<Pencil> make_pencil(const std::array<OrientedPoint, 3>& basis,
                                  double min_area_share = kMinAreaShare);

}  // namespace quadrille
