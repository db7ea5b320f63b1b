#include <cmath>
#include <stdexcept>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

Eigen::Matrix4d diagonal(double a, double b, double c, double d) {
  return Eigen::Vector4d(a, b, c, d).asDiagonal();
}

/// The matrix of ax² + by² + 2iz.
Eigen::Matrix4d with_linear_z(double a, double b, double i) {
  Eigen::Matrix4d D = diagonal(a, b, 0, 0);
  D(2, 3) = D(3, 2) = i;
  return D;
}

/// Gives the dimensions of a form in the order of its type, and the powers of them that its matrix
/// contains.
struct Dimensions {
  const CanonicalForm& form;
  double at(std::size_t i) const { return form.dimensions.at(i).second; }
  double square(std::size_t i) const { return at(i) * at(i); }
  double inverse_square(std::size_t i) const { return 1.0 / square(i); }
  double inverse_focal(std::size_t i) const { return 0.25 / at(i); }
  double cotangent_square(std::size_t i) const { return 1.0 / (std::tan(at(i)) * std::tan(at(i))); }
};

Eigen::Matrix4d central(QuadricType type, const Dimensions& d) {
  const auto inverse = [&](std::size_t i) { return d.inverse_square(i); };
  switch (type) {
    case QuadricType::kSphere:
      return diagonal(1, 1, 1, -d.square(0));
    case QuadricType::kEllipsoid:
      return diagonal(inverse(0), inverse(1), inverse(2), -1);
    case QuadricType::kHyperboloidOneSheet:
      return diagonal(inverse(0), inverse(1), -inverse(2), -1);
    case QuadricType::kHyperboloidTwoSheets:
      return diagonal(inverse(0), inverse(1), -inverse(2), 1);
    case QuadricType::kCone:
      return diagonal(d.cotangent_square(0), d.cotangent_square(0), -1, 0);
    case QuadricType::kEllipticCone:
      return diagonal(d.cotangent_square(0), d.cotangent_square(1), -1, 0);
    default:
      throw std::invalid_argument("from_canonical: an imaginary type has no dimensions");
  }
}

Eigen::Matrix4d flat_or_extruded(QuadricType type, const Dimensions& d) {
  const double half_slope = type == QuadricType::kIntersectingPlanes ? std::tan(0.5 * d.at(0)) : 0;
  switch (type) {
    case QuadricType::kCylinder:
      return diagonal(1, 1, 0, -d.square(0));
    case QuadricType::kEllipticCylinder:
      return diagonal(d.inverse_square(0), d.inverse_square(1), 0, -1);
    case QuadricType::kHyperbolicCylinder:
      return diagonal(d.inverse_square(0), -d.inverse_square(1), 0, -1);
    case QuadricType::kParallelPlanes:
      return diagonal(0, 0, 1, -0.25 * d.square(0));
    case QuadricType::kIntersectingPlanes:
      return diagonal(half_slope * half_slope, -1, 0, 0);
    case QuadricType::kCoincidentPlanes:
      return diagonal(0, 0, 1, 0);
    default:
      return central(type, d);
  }
}

Eigen::Matrix4d canonical_matrix(QuadricType type, const Dimensions& d) {
  switch (type) {
    case QuadricType::kEllipticParaboloid:
      return with_linear_z(d.inverse_focal(0), d.inverse_focal(1), -0.5);
    case QuadricType::kHyperbolicParaboloid:
      return with_linear_z(d.inverse_focal(0), -d.inverse_focal(1), -0.5);
    case QuadricType::kParabolicCylinder:
      return with_linear_z(d.inverse_focal(0), 0, -0.5);
    case QuadricType::kPlane:
      return with_linear_z(0, 0, 0.5);
    default:
      return flat_or_extruded(type, d);
  }
}

}  // namespace

Quadric from_canonical(const CanonicalForm& form) {
  return Quadric(canonical_matrix(form.type, Dimensions{form})).transformed(form.X);
}

}  // namespace quadrille
