#pragma once

#include <Eigen/Core>

#include "fit/monomials.hpp"
#include "fit/oriented_points.hpp"

namespace quadrille {

/// A linear system A q = n.
struct LinearSystem {
  Eigen::MatrixXd A;
  Eigen::VectorXd n;
};

/// The full system A′ of size 4Nx(N + 10) with a scale αᵢ per normal, A′ (q, α) = 0 (paper, eq. 4):
/// first N rows vᵢᵀ, then three rows ∇vᵢᵀ q − αᵢ nᵢ for each point.
/// @param weight  w, the weight of the normals' rows
Eigen::MatrixXd full_system(const OrientedPointsd& points, double weight = 1.0);

/// The compact system of size 4Nx10 with one common scale (paper, eq. 5): first N rows vᵢᵀq = 0,
/// then three rows ∇vᵢᵀ q = nᵢ for each point.
/// @param weight  w, the weight of the normals' rows
LinearSystem compact_system(const OrientedPointsd& points, double weight = 1.0);

}  // namespace quadrille
