#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "hand/oriented_box.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// The space that a hand passes through on its way in and while it closes, as boxes in frame C.
struct SweptHand {
  /// Both fingers, opened to the pre-shape, from the start of the approach to the grasp.
  std::array<OrientedBox, 2> fingers;
  /// The palm, from the start of the approach to the grasp.
  OrientedBox palm;
  /// The space that the fingers pass through while they close from the pre-shape to the width.
  std::array<OrientedBox, 2> closing;
  /// Boxes around the things that are fixed to the hand, from the start of the approach to the
  /// grasp.
  std::vector<OrientedBox> attached;
};

/// Sweeps the hand along a straight approach that ends at X_CG, then closes it.
/// @param preshape  distance between the pads on the way in [m]
/// @param width     distance between the pads at the end [m]
/// @param approach  length of the approach [m]
/// @param attached_G  boxes around what is fixed to the hand [m]
SweptHand sweep_hand(const Gripper& gripper, const Eigen::Isometry3d& X_CG, double preshape,
                     double width, double approach,
                     std::span<const Eigen::AlignedBox3d> attached_G = {});

/// Returns the space that the fingers fill or pass through once the hand is at X_CG, for any
/// pre-shape of at least `opening` [m]. It is part of the space of every such swept hand.
/// @param width  distance between the pads at the end [m]; no more than the opening
std::array<OrientedBox, 2> common_fingers(const Gripper& gripper, const Eigen::Isometry3d& X_CG,
                                          double opening, double width);

/// Returns the space that the palm passes through on its way to every one of many grasps, whatever
/// their width: the grasps at X_CG moved within `places_G`, which holds translations along the axes
/// of G [m]. If this space is blocked, so are all of the grasps. Nullopt if they have no space in
/// common.
std::optional<OrientedBox> common_palm(const Gripper& gripper, const Eigen::Isometry3d& X_CG,
                                       const Eigen::AlignedBox3d& places_G, double approach);

}  // namespace quadrille
