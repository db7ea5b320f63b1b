#pragma once

#include <array>
#include <optional>

#include "hand/oriented_box.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// The space that a hand passes through on its way in and while it closes, as boxes in frame C.
struct SweptHand {
  /// Both fingers, opened to the pre-shape, from the start of the approach to the grasp.
  std::array<OrientedBox, 2> fingers;
  /// The palm, from the start of the approach to the grasp.
  OrientedBox palm;
  /// What the fingers pass through while they close from the pre-shape to the width.
  std::array<OrientedBox, 2> closing;
};

/// Sweeps the hand along a straight approach that ends at X_CG, then closes it.
/// @param preshape  distance between the pads on the way in [m]
/// @param width     distance between the pads at the end [m]
/// @param approach  length of the approach [m]
SweptHand sweep_hand(const Gripper& gripper, const Eigen::Isometry3d& X_CG, double preshape,
                     double width, double approach);

/// What the fingers fill or pass through once the hand is at X_CG, however far it was opened on its
/// way, if by no less than `opening` [m]: a part of what any such swept hand holds.
/// @param width  distance between the pads at the end [m]; no more than the opening
std::array<OrientedBox, 2> common_fingers(const Gripper& gripper, const Eigen::Isometry3d& X_CG,
                                          double opening, double width);

/// What the palm passes through on its way to each of many grasps, whatever their width: those at
/// X_CG moved within `places_G`, which holds translations along the axes of G [m]. If this is in
/// the way of something, so are they all. Nullopt if they have nothing in common.
std::optional<OrientedBox> common_palm(const Gripper& gripper, const Eigen::Isometry3d& X_CG,
                                       const Eigen::AlignedBox3d& places_G, double approach);

}  // namespace quadrille
