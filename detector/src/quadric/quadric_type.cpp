#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

constexpr std::array<std::string_view, kQuadricTypeCount> kNames = {
    "sphere",
    "ellipsoid",
    "cylinder",
    "elliptic_cylinder",
    "cone",
    "elliptic_cone",
    "elliptic_paraboloid",
    "hyperbolic_paraboloid",
    "hyperboloid_one_sheet",
    "hyperboloid_two_sheets",
    "hyperbolic_cylinder",
    "parabolic_cylinder",
    "plane",
    "parallel_planes",
    "intersecting_planes",
    "coincident_planes",
    "imaginary_ellipsoid",
    "imaginary_cone",
    "imaginary_elliptic_cylinder",
    "imaginary_parallel_planes",
    "imaginary_intersecting_planes",
};

}  // namespace

std::array<QuadricType, kQuadricTypeCount> all_quadric_types() {
  std::array<QuadricType, kQuadricTypeCount> types;
  for (int i = 0; i < kQuadricTypeCount; ++i) types[i] = static_cast<QuadricType>(i);
  return types;
}

std::string_view to_string(QuadricType type) { return kNames[static_cast<int>(type)]; }

std::optional<QuadricType> quadric_type_from_string(std::string_view name) {
  for (int i = 0; i < kQuadricTypeCount; ++i) {
    if (kNames[i] == name) return static_cast<QuadricType>(i);
  }
  return std::nullopt;
}

bool is_flat(QuadricType type) {
  return type == QuadricType::kPlane || type == QuadricType::kParallelPlanes ||
         type == QuadricType::kIntersectingPlanes || type == QuadricType::kCoincidentPlanes;
}

bool is_imaginary(QuadricType type) { return type >= QuadricType::kImaginaryEllipsoid; }

double log_prior(QuadricType type) {
  // These values are guesses. Without kUncommon one more object in twenty gets a wrong type;
  // doubling kRare does not help.
  constexpr double kUncommon = -1.5, kRare = -2.0;
  switch (type) {
    case QuadricType::kEllipsoid:
    case QuadricType::kEllipticCylinder:
    case QuadricType::kEllipticCone:
    case QuadricType::kEllipticParaboloid:
    case QuadricType::kHyperboloidOneSheet:
      return kUncommon;
    case QuadricType::kHyperboloidTwoSheets:
    case QuadricType::kHyperbolicParaboloid:
    case QuadricType::kHyperbolicCylinder:
    case QuadricType::kParabolicCylinder:
      return kRare;
    default:
      return 0.0;
  }
}

}  // namespace quadrille
