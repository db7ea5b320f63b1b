#pragma once

#include <cmath>

#include "picture/picture.hpp"

namespace quadrille::test {

/// A half sphere of radius 0.1 m, 0.6 m before the camera, in front of a wall.
inline PointCloud ball_before_wall() {
  PointCloud cloud;
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const Eigen::Vector3d ray((column - 79.5) / 150, (row - 59.5) / 150, 1);
      const double a = ray.squaredNorm(), b = -0.6, c = 0.36 - 0.01;
      const double discriminant = b * b - a * c;
      const double z = discriminant >= 0 ? (-b - std::sqrt(discriminant)) / a : 1.0;
      cloud.points.push_back((z * ray).cast<float>());
    }
  }
  return cloud;
}

inline DetectionResult ball_found() {
  Detection d;
  d.id = 1;
  d.type = QuadricType::kSphere;
  Vector10d q = Vector10d::Zero();
  q.head<3>().setOnes();
  q[9] = -0.01;
  d.X_CQ.translation() = Eigen::Vector3d(0, 0, 0.6);
  d.Q_C = Quadric(q).transformed(d.X_CQ);
  d.rms = 0.001;
  d.extent_Q = {Eigen::Vector3d(-.1, -.1, -.1), Eigen::Vector3d(.1, .1, .1)};
  d.dimensions = {{"radius", 0.1, 0.0}};
  DetectionResult result;
  result.detections = {d};
  return result;
}

/// A hand around the ball, from before it.
inline GraspPlan plan_on_ball() {
  GraspPlan plan;
  Grasp grasp;
  grasp.target = 1;
  grasp.preshape = 0.08;
  grasp.X_CG.translation() = Eigen::Vector3d(0, 0, 0.6);
  grasp.contacts_C = {Eigen::Vector3d(0, -0.04, 0.6), Eigen::Vector3d(0, 0.04, 0.6)};
  plan.grasps = {grasp};
  return plan;
}

inline Gripper make_gripper() {
  Gripper gripper;
  gripper.finger = {0.02, 0.02, 0.05};
  gripper.palm = {0.06, 0.2, 0.06};
  return gripper;
}

}  // namespace quadrille::test
