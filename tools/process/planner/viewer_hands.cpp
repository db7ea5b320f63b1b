#include "process/planner/viewer_hands.hpp"

#include <algorithm>

namespace quadrille {

std::vector<ViewerLink> hand_links(const GraspPlan& plan, const Gripper& gripper) {
  constexpr std::array<float, 4> kFinger = {0.25f, 1.0f, 0.3f, 0.9f};
  constexpr std::array<float, 4> kPalm = {0.2f, 0.7f, 0.25f, 0.9f};
  if (plan.grasps.empty()) return {};
  const Grasp& best = plan.grasps.front();
  const double opening = std::max(best.preshape, best.width);
  const double back = -gripper.reach(opening);
  // The given size of the fingers applies at the largest opening.
  Eigen::Vector3d finger = gripper.finger;
  finger.z() = gripper.finger_front - back;
  ViewerLink hand{"quadrille::hand", best.X_CG, {}};
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d p_G(0.0, side * 0.5 * (opening + finger.y()),
                              0.5 * (gripper.finger_front + back));
    hand.shapes.push_back(box_shape(finger, Eigen::Isometry3d(Eigen::Translation3d(p_G)), kFinger));
  }
  const Eigen::Vector3d p_G(0.0, 0.0, back - 0.5 * gripper.palm.z());
  hand.shapes.push_back(
      box_shape(gripper.palm, Eigen::Isometry3d(Eigen::Translation3d(p_G)), kPalm));
  return {hand};
}

}  // namespace quadrille
