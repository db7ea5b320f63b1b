#pragma once

namespace quadrille {

/// Sets of quadrics that a fit can be restricted to, simplest first.
enum class Family {
  kPlane,             ///< 3 degrees of freedom
  kSphere,            ///< 4
  kCylinder,          ///< 5, circular
  kCone,              ///< 6, circular
  kParaboloid,        ///< 6, of revolution
  kRevolution,        ///< 7: any quadric of revolution, x² + y² + c z² + 2 i z + j = 0
  kEllipticCylinder,  ///< 7: any central cylinder over a conic
  kParabolic,         ///< 8: any elliptic or hyperbolic paraboloid
  kGeneral,           ///< 9
};

inline constexpr int kFamilyCount = 9;

}  // namespace quadrille
