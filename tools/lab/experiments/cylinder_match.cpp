#include "lab/experiments/cylinder_match.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace quadrille::experiments {
namespace {

bool agrees(const Detection& found, const KnownCylinder& truth, const CylinderTolerance& t) {
  if (found.type != QuadricType::kCylinder || found.dimensions.empty()) return false;
  const Eigen::Vector3d axis = found.X_CQ.linear().col(2);
  const double offset = axis.cross(truth.centre_C - found.X_CQ.translation()).norm();
  return axis.cross(truth.axis_C).norm() <= std::sin(t.angle) &&
         offset <= t.offset * truth.radius &&
         std::abs(found.dimensions.front().value - truth.radius) <= t.radius * truth.radius;
}

}  // namespace

std::vector<char> found_cylinders(const DetectionResult& result,
                                  const std::vector<KnownCylinder>& known,
                                  const CylinderTolerance& tolerance) {
  std::vector<char> found(known.size(), 0);
  for (const Detection& detection : result.detections) {
    for (std::size_t k = 0; k < known.size(); ++k) {
      if (found[k] || !agrees(detection, known[k], tolerance)) continue;
      found[k] = 1;
      break;
    }
  }
  return found;
}

}  // namespace quadrille::experiments
