#include "hand/hand.hpp"

#include <algorithm>

namespace quadrille {

SweptHand sweep_hand(const Gripper& gripper, const Eigen::Isometry3d& X_CG, double preshape,
                     double width, double approach,
                     std::span<const Eigen::AlignedBox3d> attached_G) {
  const double x = 0.5 * gripper.finger.x();
  const double thick = gripper.finger.y();
  // The frame G is that of the closed hand. Fingers on links reach farther forward once closed, and
  // the tips may also draw back a little at the end.
  const double back = -gripper.reach(width);
  const double tip =
      gripper.finger_front + gripper.max_extension(width, preshape) - gripper.extension(width);
  SweptHand hand;
  for (int i = 0; i < 2; ++i) {
    const double side = i == 0 ? 1.0 : -1.0;
    const auto between = [&](double y0, double y1, double z0) {
      return box_between(X_CG, {-x, std::min(side * y0, side * y1), z0},
                         {x, std::max(side * y0, side * y1), tip});
    };
    hand.fingers[i] = between(0.5 * preshape, 0.5 * preshape + thick, back - approach);
    hand.closing[i] = between(0.5 * std::min(width, preshape), 0.5 * preshape, back);
  }
  const Eigen::Vector3d palm = 0.5 * gripper.palm;
  hand.palm = box_between(X_CG, {-palm.x(), -palm.y(), back - gripper.palm.z() - approach},
                          {palm.x(), palm.y(), back});
  for (const Eigen::AlignedBox3d& box : attached_G) {
    const Eigen::Vector3d start = box.min() - Eigen::Vector3d(0, 0, approach);
    hand.attached.push_back(box_between(X_CG, start, box.max()));
  }
  return hand;
}

std::array<OrientedBox, 2> common_fingers(const Gripper& gripper, const Eigen::Isometry3d& X_CG,
                                          double opening, double width) {
  const double x = 0.5 * gripper.finger.x(), back = -gripper.reach(width);
  const double in = 0.5 * width, out = 0.5 * opening + gripper.finger.y();
  const Eigen::Vector3d low(-x, in, back), high(x, out, gripper.finger_front);
  return {box_between(X_CG, low, high), box_between(X_CG, {-x, -out, back}, {x, -in, high.z()})};
}

std::optional<OrientedBox> common_palm(const Gripper& gripper, const Eigen::Isometry3d& X_CG,
                                       const Eigen::AlignedBox3d& places_G, double approach) {
  const double narrow = gripper.min_opening, wide = gripper.max_opening;
  // Fingers on links reach farthest somewhere in between, and least at one of the two openings.
  const double min_reach = std::min(gripper.reach(narrow), gripper.reach(wide));
  const double max_reach = gripper.reach(wide) + gripper.max_extension(narrow, wide);
  const Eigen::Vector3d palm(0.5 * gripper.palm.x(), 0.5 * gripper.palm.y(), gripper.palm.z());
  const Eigen::Vector3d low = places_G.max() - palm - Eigen::Vector3d(0, 0, min_reach + approach);
  const Eigen::Vector3d high = places_G.min() + Eigen::Vector3d(palm.x(), palm.y(), -max_reach);
  if ((low.array() >= high.array()).any()) return std::nullopt;
  return box_between(X_CG, low, high);
}

}  // namespace quadrille
