#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "fit/oriented_point.hpp"

namespace quadrille {

/// The pencil of quadrics through three oriented points, f = f₀ + λ z² (paper, theorems 1 and 3).
///
/// Let m be the unit normal of the points' plane, z = m·(x − x₁), and uᵢ the barycentric
/// coordinates of the projection into that plane. Then every quadric through the points is
///   f = c₁₂u₁u₂ + c₂₃u₂u₃ + c₃₁u₃u₁ + z (l₁u₁ + l₂u₂ + l₃u₃) + λ z².
/// The gradient at xᵢ is nᵢ for c_ij = nᵢ·(x_j − xᵢ) and lᵢ = nᵢ·m. The lengths of the normals
/// matter: unit normals are the paper's common scale, which is exact only on spheres and circular
/// cylinders. Only λ stays free: z² is the data plane squared, the trivial solution of theorem 1.
struct Pencil {
  /// f₀ as a symmetric 4x4 matrix.
  Eigen::Matrix4d Q0;
  /// The data plane (m, −m·x₁), so that z(x) = plane · [x 1].
  Eigen::Vector4d plane;

  /// Returns Q₀ + λ plane planeᵀ.
  Eigen::Matrix4d at(double lambda) const { return Q0 + lambda * plane * plane.transpose(); }
};

/// Measures, from 0 to 1, how far three oriented points are from lying on one quadric. They lie on
/// one exactly if b₁₂b₂₃b₃₁ = b₂₁b₃₂b₁₃ with b_ij = nᵢ·(x_j − xᵢ) and b_ij, b_ji of one sign.
double inconsistency(const std::array<OrientedPoint, 3>& basis);

/// Largest inconsistency of a basis of noisy points; on a worse one a vote is wasted.
inline constexpr double kMaxInconsistency = 0.6;

/// Least value of twice a noisy basis's triangle area over the square of its longest side. The
/// plane of a thinner triangle is determined by noise.
inline constexpr double kMinAreaShare = 0.05;

/// Makes the pencil of a basis by the closed form above.
/// @param basis  points whose normals have the lengths of the gradients
/// @return nullopt if the points are (nearly) collinear or coincide
std::optional<Pencil> make_pencil(const std::array<OrientedPoint, 3>& basis,
                                  double min_area_share = kMinAreaShare);

}  // namespace quadrille
