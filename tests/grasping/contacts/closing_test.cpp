#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/body.hpp"
#include "grasping/plans.hpp"

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

/// A solid by itself, askew before a camera at the origin.
Detection askew(Detection detection) {
  detection.X_CQ.linear() =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 0.5).normalized()).matrix();
  detection.X_CQ.translation() = Eigen::Vector3d(0.05, 0.02, 0.7);
  return detection;
}

}  // namespace

TEST_CASE("closing fingers reach contacts on their pads before they meet the target elsewhere",
          "[plan][closing]") {
  const Gripper hand = franka_hand();
  std::size_t grasps = 0;
  for (const Detection& solid : solid_detections()) {
    const Detection d = askew(solid);
    const std::vector<Eigen::Vector3d> side = side_of(make_body(d).value());
    CAPTURE(to_string(d.type));
    for (const Grasp& grasp : plan_alone({d}).grasps) {
      ++grasps;
      const Eigen::Isometry3d X_GC = grasp.X_CG.inverse();
      for (const Eigen::Vector3d& contact_C : grasp.contacts_C) {
        const Eigen::Vector3d p_G = X_GC * contact_C;
        CHECK(std::abs(p_G.x()) <= 0.5 * hand.pad.x() - 0.001 + 1e-9);
        CHECK(p_G.z() <= hand.finger_front - 0.001 + 1e-9);
      }
      if (d.type == QuadricType::kParallelPlanes) continue;
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
    }
  }
  CHECK(grasps > 50);
}
