#include "picture/grasp_layer.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace quadrille {
namespace {

constexpr int kThinPerTarget = 3;
const Color kInk(0.05f, 0.05f, 0.05f), kBest(0.25f, 1.0f, 0.3f), kOther(0.75f, 0.95f, 0.75f),
    kContact(1.0f, 0.25f, 0.2f);

/// Returns the start of the drawn approach along z of the hand; it ends at the wrist.
double approach_start(const Grasp& grasp, const Gripper& gripper) {
  return -gripper.reach(grasp.width) - gripper.palm.z() - std::min(grasp.approach, 0.1);
}

/// Returns the lines of a hand that lie in front of the eye.
std::vector<Segment> outline_hand(const Grasp& grasp, const Gripper& gripper, const View& view) {
  const double half = std::max(grasp.preshape, grasp.width) / 2, tip = gripper.finger_front;
  const double back = -gripper.reach(grasp.width), start = approach_start(grasp, gripper);
  std::vector<Segment> segments;
  const auto line = [&](const Eigen::Vector3d& from_G, const Eigen::Vector3d& to_G) {
    const auto from = view.project(grasp.X_CG * from_G), to = view.project(grasp.X_CG * to_G);
    if (from && to) segments.push_back({*from, *to});
  };
  line({0, -half, tip}, {0, -half, back});
  line({0, half, tip}, {0, half, back});
  line({0, -half, back}, {0, half, back});
  line({0, 0, back}, {0, 0, start});
  return segments;
}

}  // namespace

Sketch sketch_grasps(const GraspPlan& plan, const Gripper& gripper, const View& view) {
  Sketch sketch;
  std::map<int, int> drawn;
  std::vector<const Grasp*> best;
  for (const Grasp& grasp : plan.grasps) {
    const int rank = drawn[grasp.target]++;
    if (rank == 0) best.push_back(&grasp);
    if (rank == 0 || rank > kThinPerTarget) continue;
    sketch.strokes.push_back({outline_hand(grasp, gripper, view), 1.5, kOther, 0.6f});
  }
  // The best hands are drawn last, so that they lie on top.
  std::reverse(best.begin(), best.end());
  for (const Grasp* grasp : best) {
    const std::vector<Segment> hand = outline_hand(*grasp, gripper, view);
    sketch.strokes.push_back({hand, 8.0, kInk, 0.8f});
    sketch.strokes.push_back({hand, 4.5, kBest, 1.0f});
    for (const Eigen::Vector3d& contact : grasp->contacts_C) {
      const auto at = view.project(contact);
      if (!at) continue;
      sketch.discs.push_back({*at, 6.0, kInk});
      sketch.discs.push_back({*at, 4.0, kContact});
    }
  }
  return sketch;
}

std::vector<Eigen::Vector3d> hand_points(const GraspPlan& plan, const Gripper& gripper) {
  std::vector<Eigen::Vector3d> points;
  std::set<int> targets;
  for (const Grasp& grasp : plan.grasps) {
    if (!targets.insert(grasp.target).second) continue;
    points.push_back(grasp.X_CG * Eigen::Vector3d(0, 0, approach_start(grasp, gripper)));
  }
  return points;
}

}  // namespace quadrille
