#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "body/body.hpp"
#include "grasping/scenes.hpp"
#include "quadrille/grasping/plan.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Points of the side of a body, in frame C.
std::vector<Eigen::Vector3d> side_of(const Body& body) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 80; ++i) {
    const double z = body.z_min + i * (body.z_max - body.z_min) / 80.0, s = body.scale(z);
    for (int k = 0; k < 120; ++k) {
      const double t = 2.0 * std::numbers::pi * k / 120.0;
      points.push_back(body.X_CQ *
                       Eigen::Vector3d(body.a * s * std::cos(t), body.b * s * std::sin(t), z));
    }
  }
  return points;
}

/// The grasps of each solid by itself, in free space, a camera at the origin.
GraspPlan plan_alone(Detection& detection) {
  detection.X_CQ.linear() =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 0.5).normalized()).matrix();
  detection.X_CQ.translation() = Eigen::Vector3d(0.05, 0.02, 0.7);
  PointCloud cloud;
  for (int i = 0; i < 50; ++i) cloud.points.emplace_back(3.0f, 0.01f * i, 3.0f);
  PlanOptions options;
  options.unknown = UnknownPolicy::kFree;
  return plan_grasps(cloud, {detection}, franka_hand(), options);
}

}  // namespace

TEST_CASE("closing fingers reach the contacts before they meet the target elsewhere",
          "[plan][closing]") {
  const Gripper hand = franka_hand();
  std::size_t grasps = 0;
  for (Detection d : solid_detections()) {
    if (d.type == QuadricType::kParallelPlanes) continue;
    const GraspPlan plan = plan_alone(d);
    const std::vector<Eigen::Vector3d> side = side_of(make_body(d).value());
    CAPTURE(to_string(d.type));
    for (const Grasp& grasp : plan.grasps) {
      const Eigen::Isometry3d X_GC = grasp.X_CG.inverse();
      double outermost = 0.0;
      for (const Eigen::Vector3d& p_C : side) {
        const Eigen::Vector3d p = X_GC * p_C;
        if (std::abs(p.x()) < 0.5 * hand.finger.x() && p.z() < hand.finger_front &&
            p.z() > -hand.reach(grasp.width)) {
          outermost = std::max(outermost, std::abs(p.y()));
        }
      }
      // The pads' margin, and the 0.3 mm that a flush finger is granted.
      CHECK(outermost < 0.5 * grasp.width + PlanOptions().pad_margin + 0.0003 + 1e-5);
      ++grasps;
    }
  }
  CHECK(grasps > 50);
}

TEST_CASE("both contacts of a grasp lie on the pads, not past their edges", "[plan][closing]") {
  const Gripper hand = franka_hand();
  std::size_t grasps = 0;
  for (Detection d : solid_detections()) {
    CAPTURE(to_string(d.type));
    const GraspPlan plan = plan_alone(d);
    grasps += plan.grasps.size();
    for (const Grasp& grasp : plan.grasps) {
      for (const Eigen::Vector3d& contact_C : grasp.contacts_C) {
        const Eigen::Vector3d p_G = grasp.X_CG.inverse() * contact_C;
        CHECK(std::abs(p_G.x()) <= 0.5 * hand.pad.x() - 0.001 + 1e-9);
        CHECK(p_G.z() <= hand.finger_front - 0.001 + 1e-9);
      }
    }
  }
  CHECK(grasps > 50);
}
