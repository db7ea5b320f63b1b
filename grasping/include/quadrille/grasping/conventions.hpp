#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string_view>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// The ways in which other software writes down the pose of a two-finger hand, each described in
/// terms of the grasp frame G (origin midway between the pads, z approach, y closing).
enum class HandConvention {
  kDrake,     ///< body of Drake's Schunk WSG: y approach, x closing; origin in the body, `tcp` back
  kMoveit,    ///< MoveIt, hand link of the Franka: z approach, y closing; origin `tcp` back
  kGpd,       ///< GPD: x approach, y closing ("binormal"); origin at the palm's front ("bottom")
  kGraspnet,  ///< GraspNet: x approach, y closing; origin midway between the pads
};

inline constexpr std::array<HandConvention, 4> kHandConventions = {
    HandConvention::kDrake, HandConvention::kMoveit, HandConvention::kGpd,
    HandConvention::kGraspnet};

/// Returns "drake", "moveit", "gpd" or "graspnet".
QUADRILLE_EXPORT std::string_view to_string(HandConvention convention);

/// Returns the pose X_GH of the convention's hand frame H in G: a rotation by quarter turns and an
/// offset back along the approach. If the fingers swing on links, the offset depends on the width.
/// @param width  distance between the pads at the end of the grasp [m]
QUADRILLE_EXPORT Eigen::Isometry3d hand_in_grasp(HandConvention convention, const Gripper& gripper,
                                                 double width);

/// Returns the hand's pose X_CH for a grasp at X_CG.
QUADRILLE_EXPORT Eigen::Isometry3d hand_pose(HandConvention convention, const Gripper& gripper,
                                             const Eigen::Isometry3d& X_CG, double width);

/// Returns the grasp X_CG for a hand at X_CH; the inverse of hand_pose().
QUADRILLE_EXPORT Eigen::Isometry3d grasp_of_hand(HandConvention convention, const Gripper& gripper,
                                                 const Eigen::Isometry3d& X_CH, double width);

}  // namespace quadrille
