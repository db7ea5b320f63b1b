// Plans grasps on a known quadric without a detector: an upright can of 3 cm radius in front of the
// camera, in otherwise empty space.
#include <cmath>
#include <iomanip>
#include <iostream>

#include "quadrille/grasping/plan.hpp"

// The can as a detection. Its axis runs along y, which points down in the camera's frame.
quadrille::Detection can() {
  const double radius = 0.03, length = 0.10;

  quadrille::Detection can;
  can.id = 1;
  can.type = quadrille::QuadricType::kCylinder;
  can.score = 1.0;
  can.X_CQ = Eigen::Translation3d(0.0, 0.0, 0.5) *
             Eigen::AngleAxisd(-M_PI / 2.0, Eigen::Vector3d::UnitX());
  const Eigen::Vector4d diagonal(1.0, 1.0, 0.0, -radius * radius);
  const quadrille::Quadric Q_Q(Eigen::Matrix4d(diagonal.asDiagonal()));
  can.Q_C = Q_Q.transformed(can.X_CQ).normalized();
  can.dimensions = {{"radius", radius, 0.0}, {"length", length, 0.0}};
  can.extent_Q = Eigen::AlignedBox3d(Eigen::Vector3d(-radius, -radius, -length / 2.0),
                                     Eigen::Vector3d(radius, radius, length / 2.0));
  can.seen = 0.5;
  return can;
}

// The part of the can that a camera at the origin sees: the near half of its lateral surface.
quadrille::PointCloud view_of(const quadrille::Detection& can) {
  quadrille::PointCloud cloud;
  for (double height = -0.05; height <= 0.05; height += 0.001) {
    for (double angle = -M_PI / 2.0; angle <= M_PI / 2.0; angle += 0.02) {
      const Eigen::Vector3d p_Q(0.03 * std::sin(angle), -0.03 * std::cos(angle), height);
      const Eigen::Vector3d p_C = can.X_CQ * p_Q;
      cloud.points.push_back(p_C.cast<float>());
    }
  }
  return cloud;
}

int main() {
  const quadrille::Detection target = can();
  quadrille::PlanOptions options;
  options.unknown = quadrille::UnknownPolicy::kFree;

  const quadrille::GraspPlan plan =
      quadrille::plan_grasps(view_of(target), {target}, quadrille::franka_hand(), options);

  std::cout << std::fixed << std::setprecision(3);
  for (const quadrille::Grasp& grasp : plan.grasps) {
    std::cout << "score " << grasp.score << ": close to " << 1000.0 * grasp.width << " mm at "
              << grasp.X_CG.translation().transpose() << " m, approaching along "
              << grasp.X_CG.linear().col(2).transpose() << '\n';
  }
  std::cout << "refused candidates by reason:";
  for (const auto& [reason, count] : plan.rejected) std::cout << "  " << reason << ' ' << count;
  std::cout << '\n';
}
