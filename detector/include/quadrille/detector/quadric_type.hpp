#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "quadrille/detector/export.hpp"

namespace quadrille {

/// The 17 real and imaginary affine types of quadrics; the rotational special cases (sphere,
/// circular cylinder, circular cone) and the single plane have names of their own.
enum class QuadricType {
  kSphere,
  kEllipsoid,
  kCylinder,
  kEllipticCylinder,
  kCone,
  kEllipticCone,
  kEllipticParaboloid,
  kHyperbolicParaboloid,
  kHyperboloidOneSheet,
  kHyperboloidTwoSheets,
  kHyperbolicCylinder,
  kParabolicCylinder,
  kPlane,
  kParallelPlanes,
  kIntersectingPlanes,
  kCoincidentPlanes,
  kImaginaryEllipsoid,
  kImaginaryCone,
  kImaginaryEllipticCylinder,
  kImaginaryParallelPlanes,
  kImaginaryIntersectingPlanes,
};

inline constexpr int kQuadricTypeCount = 21;

/// All types, in the order of the enumeration.
QUADRILLE_EXPORT std::array<QuadricType, kQuadricTypeCount> all_quadric_types();

/// The name used in JSON, messages and options, such as "elliptic_cylinder".
QUADRILLE_EXPORT std::string_view to_string(QuadricType type);

/// The type with the given name; nullopt if there is none.
QUADRILLE_EXPORT std::optional<QuadricType> quadric_type_from_string(std::string_view name);

/// True for a plane and for pairs of planes.
QUADRILLE_EXPORT bool is_flat(QuadricType type);

/// True for the types whose real points are none, a single point or a single line.
QUADRILLE_EXPORT bool is_imaginary(QuadricType type);

/// Natural logarithm of how frequent objects of this type are, relative to the common, circular
/// types. Saddles, hyperboloids of two sheets, and parabolic and hyperbolic cylinders are rare, but
/// noisy other shapes and rounded edges of boxes pass for them.
QUADRILLE_EXPORT double log_prior(QuadricType type);

/// Sets of quadrics to which a fit can be restricted, simplest first.
enum class Family {
  kPlane,             ///< 3 degrees of freedom
  kSphere,            ///< 4 degrees of freedom
  kCylinder,          ///< 5; circular
  kCone,              ///< 6; circular
  kParaboloid,        ///< 6; of revolution
  kRevolution,        ///< 7; any quadric of revolution, x² + y² + c z² + 2 i z + j = 0
  kEllipticCylinder,  ///< 7; any central cylinder over a conic
  kParabolic,         ///< 8; any elliptic or hyperbolic paraboloid
  kGeneral,           ///< 9; any quadric
};

inline constexpr int kFamilyCount = 9;

}  // namespace quadrille
