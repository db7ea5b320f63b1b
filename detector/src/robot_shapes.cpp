#include "quadrille/detector/robot_shapes.hpp"

#include <limits>
#include <stdexcept>

#include "quadrille/detector/near_shape.hpp"

namespace quadrille {

PointCloud RobotShapes::taken_from(PointCloud cloud) const {
  for (const SolidShape& shape : shapes) {
    const NearShape near(shape, padding);
    const Eigen::AlignedBox3f bounds = near.bounds_C().cast<float>();
    for (Eigen::Vector3f& p : cloud.points) {
      if (bounds.contains(p) && near.contains(p.cast<double>())) {
        p.setConstant(std::numeric_limits<float>::quiet_NaN());
      }
    }
  }
  return cloud;
}

void RobotShapes::check() const {
  if (!(padding >= 0.0 && padding <= 1.0)) {
    throw std::invalid_argument("padding: must be between 0 and 1 m");
  }
  for (const SolidShape& shape : shapes) shape.check();
}

RobotShapes moved(RobotShapes robot, const Eigen::Isometry3d& X_FC) {
  for (SolidShape& shape : robot.shapes) shape.X_CS = X_FC * shape.X_CS;
  return robot;
}

}  // namespace quadrille
