#pragma once

#include <Eigen/Core>

namespace quadrille {

/// Computes d_close(Q₁, Q₂) = max(‖Q₁ Q₂⁺ − Q₂ Q₂⁺‖, ‖Q₂ Q₁⁺ − Q₁ Q₁⁺‖) (Frobenius norms), or
/// infinity if ‖q₁ − q₂‖₁ ≥ τ.
///
/// This differs from the printed formula in three ways. The paper has the unit matrix for Q₂ Q₂⁺;
/// for the singular matrices of cones, cylinders and planes, equal ones would then be at distance
/// one or more. It multiplies by the indicator of ‖q₁ − q₂‖₁ < τ, which would make the most
/// different quadrics coincide. And it has one direction only, which ignores the null space of Q₂:
/// an ellipsoid along a cylinder would be close to it.
/// @param a, b  symmetric 4x4 matrices in one frame, best normalised to the unit ball; their
///   scales, signs and order do not matter
double close_distance(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b, double tau);

}  // namespace quadrille
