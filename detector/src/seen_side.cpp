#include "quadrille/detector/detection.hpp"

namespace quadrille {
namespace {

/// True if the z axis of the canonical frame lies inside the surface.
bool surrounds_axis(QuadricType type) {
  switch (type) {
    case QuadricType::kSphere:
    case QuadricType::kEllipsoid:
    case QuadricType::kCylinder:
    case QuadricType::kEllipticCylinder:
    case QuadricType::kCone:
    case QuadricType::kEllipticCone:
    case QuadricType::kEllipticParaboloid:
    case QuadricType::kHyperboloidOneSheet:
    case QuadricType::kHyperboloidTwoSheets:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool shows_inside(const Detection& detection) {
  if (!surrounds_axis(detection.type) || detection.extent_Q.isEmpty()) return false;
  // The function f increases towards the side that the sensor saw.
  const double middle = detection.extent_Q.center().z();
  return detection.Q_C.value(detection.X_CQ * Eigen::Vector3d(0.0, 0.0, middle)) > 0.0;
}

}  // namespace quadrille
