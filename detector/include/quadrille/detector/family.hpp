#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

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

/// What may change in a family: the canonical matrix D of Q = X⁻ᵀ D X⁻¹ by a sum of the shapes,
/// and the pose X by the motions.
struct FamilySpec {
  std::string_view name;
  /// Symmetric 4x4 directions of D.
  std::vector<Eigen::Matrix4d> shapes;
  /// Generators in the canonical frame: translations x y z are 0 1 2, rotations 3 4 5.
  std::vector<int> motions;
  /// Degrees of freedom of the surface (the scale of Q does not count).
  int dof;
};

const FamilySpec& family_spec(Family family);

}  // namespace quadrille
