#pragma once

#include <Eigen/Core>

namespace quadrille {

/// d_close(Q₁, Q₂) = max(‖Q₁ Q₂⁺ − Q₂ Q₂⁺‖, ‖Q₂ Q₁⁺ − Q₁ Q₁⁺‖) (Frobenius), and infinity where
/// ‖q₁ − q₂‖₁ ≥ τ.
///
/// Printed are the unit matrix for Q₂ Q₂⁺, which for the singular matrices of cones, cylinders and
/// planes would leave a distance of one or more between equal ones; a product with the indicator of
/// ‖q₁ − q₂‖₁ < τ, which would make the most different quadrics coincide; and one direction alone,
/// which is blind in the null space of Q₂: an ellipsoid along a cylinder would be close to it.
/// @param a, b  symmetric 4x4 matrices in one frame, best normalised to the unit ball; their
///              scales, signs and order do not count
double close_distance(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b, double tau);

}  // namespace quadrille
