#pragma once

#include <Eigen/Core>

#include "body/body.hpp"

namespace quadrille {

/// A body's quadric x²/a² + y²/b² − s(z)² = xᵀ diag(M) x + gᵀx + k in its frame Q.
struct DiagonalQuadric {
  Eigen::Vector3d M, g;
  double k;
};

/// Returns the quadric of any body except a box.
DiagonalQuadric quadric_of(const Body& body);

}  // namespace quadrille
