// Goes from a cloud to grasps and a map with both libraries and without LCM: a can on a table.
#include <octomap/OcTree.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>

#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/plan.hpp"

// Distance along a ray to an upright can of 3 cm radius and 12 cm height, or to the table at z = 0
// on which it stands.
double range_of(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) {
  const double radius = 0.03, height = 0.12;
  double range = ray.z() < 0.0 ? -eye.z() / ray.z() : std::numeric_limits<double>::infinity();
  const double a = ray.head<2>().squaredNorm(), b = ray.head<2>().dot(eye.head<2>());
  const double square = b * b - a * (eye.head<2>().squaredNorm() - radius * radius);
  if (square > 0.0) {
    const double side = (-b - std::sqrt(square)) / a, z = eye.z() + side * ray.z();
    if (z > 0.0 && z < height) range = std::min(range, side);
  }
  const double top = (height - eye.z()) / ray.z();
  if (top > 0.0 && (eye + top * ray).head<2>().norm() < radius) range = std::min(range, top);
  return range;
}

// The cloud that a depth camera sees from 64 cm away, looking down by 40 degrees.
quadrille::PointCloud can_on_table() {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.translation() = Eigen::Vector3d(-0.45, 0.0, 0.45);
  X_WC.linear().col(2) = (Eigen::Vector3d(0.0, 0.0, 0.05) - X_WC.translation()).normalized();
  X_WC.linear().col(0) = -Eigen::Vector3d::UnitY();
  X_WC.linear().col(1) = X_WC.linear().col(2).cross(X_WC.linear().col(0));

  quadrille::PointCloud cloud;
  cloud.width = 320;
  cloud.height = 240;
  for (int row = 0; row < cloud.height; ++row) {
    for (int column = 0; column < cloud.width; ++column) {
      const Eigen::Vector3d ray_C((column - 159.5) / 280.0, (row - 119.5) / 280.0, 1.0);
      const double range = range_of(X_WC.translation(), X_WC.linear() * ray_C);
      // Points that are too far away are missing.
      const double seen = range < 2.0 ? range : std::numeric_limits<double>::quiet_NaN();
      cloud.points.push_back((seen * ray_C).cast<float>());
    }
  }
  return cloud;
}

int main() {
  const quadrille::PointCloud cloud = can_on_table();
  const quadrille::DetectionResult found = quadrille::detect(cloud);
  const quadrille::GraspPlan plan = quadrille::plan_grasps(
      cloud, found.detections, quadrille::franka_hand(), {}, {}, {}, found.boxes, found.bodies);

  std::cout << std::fixed << std::setprecision(3);
  for (const quadrille::Detection& detection : found.detections) {
    std::cout << detection.id << ' ' << to_string(detection.type);
    for (const auto& [name, value, std] : detection.dimensions) {
      std::cout << ' ' << name << ' ' << value;
    }
    std::cout << '\n';
  }
  if (!plan.grasps.empty()) {
    const quadrille::Grasp& best = plan.grasps.front();
    std::cout << plan.grasps.size() << " grasps; the best, of " << best.target << ", closes to "
              << best.width << " m at " << best.X_CG.translation().transpose() << '\n';
  }
  std::cout << "refused candidates by reason:";
  for (const auto& [reason, count] : plan.rejected) std::cout << "  " << reason << ' ' << count;
  std::cout << '\n';

  // The map holds free and occupied space around the targets, in the format of octovis and your
  // planner.
  plan.space->to_octree()->writeBinary("scene.bt");
  std::cout << "scene.bt holds the map\n";
}
