#pragma once

#include <optional>

#include "fit/geometric_fit.hpp"

namespace quadrille {

/// Closed-form starts for the geometric fits. Each returns nullopt where the points do not
/// determine the surface.

/// Centroid and direction of least spread.
std::optional<PosedQuadric> initial_plane(const FitPoints& points);
/// Linear least squares of |x|² + 2 b·x + j = 0.
std::optional<PosedQuadric> initial_sphere(const FitPoints& points);
/// Axis across all normals (least eigenvector of Σ n nᵀ), circle by linear least squares.
std::optional<PosedQuadric> initial_cylinder(const FitPoints& points);
/// Axis at a constant angle to all normals; apex where all tangent planes meet.
std::optional<PosedQuadric> initial_cone(const FitPoints& points);
/// Axis that all normal lines meet (linear line complex: Pottmann, Wallner, 2001), profile
/// ρ² = α + β s + γ s² by linear least squares.
std::optional<PosedQuadric> initial_revolution(const FitPoints& points);
/// The same with γ = 0.
std::optional<PosedQuadric> initial_paraboloid(const PosedQuadric& revolution);
/// Cone and cylinder that touch a surface of revolution where the points are, at z = 0.
std::optional<PosedQuadric> tangent_cone(const PosedQuadric& revolution);
std::optional<PosedQuadric> tangent_cylinder(const PosedQuadric& revolution);
/// Any quadric with the least eigenvalue of its upper left 3x3 block set to zero, about its vertex:
/// λ₁x² + λ₂y² + 2z = 0.
std::optional<PosedQuadric> nearest_parabolic(const PosedQuadric& general);
/// The same about its axis, and without a linear part along it: λ₁x² + λ₂y² - 1 = 0.
std::optional<PosedQuadric> nearest_cylindrical(const PosedQuadric& general);
/// Taubin's fit: generalised eigenvalue problem of the scatter of v and of its gradient
/// (Taubin, PAMI 1991).
std::optional<PosedQuadric> initial_general(const FitPoints& points);

}  // namespace quadrille
