#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string_view>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// How other software writes down the pose of a two-finger hand. In terms of the grasp frame G
/// (origin midway between the pads, z approach, y closing):
enum class HandConvention {
  kDrake,     ///< body of Drake's Schunk WSG: y approach, x closing; origin in the body, `tcp` back
  kMoveit,    ///< MoveIt, the Franka's hand link: z approach, y closing; origin `tcp` back
  kGpd,       ///< GPD: x approach, y closing ("binormal"); origin at the palm's front ("bottom")
  kGraspnet,  ///< GraspNet: x approach, y closing; origin midway between the pads
};

inline constexpr std::array<HandConvention, 4> kHandConventions = {
    HandConvention::kDrake, HandConvention::kMoveit, HandConvention::kGpd,
    HandConvention::kGraspnet};

/// "drake", "moveit", "gpd" or "graspnet".
QUADRILLE_EXPORT std::string_view to_string(HandConvention convention);

/// Pose X_GH of the convention's hand frame H in G: a rotation by quarter turns and an offset back
/// along the approach. Hands whose fingers swing on links have an offset that depends on the width.
/// @param width  distance between the pads at the end of the grasp [m]
QUADRILLE_EXPORT Eigen::Isometry3d hand_in_grasp(HandConvention convention, const Gripper& gripper,
                                                 double width);

/// The hand's pose X_CH of a grasp X_CG.
QUADRILLE_EXPORT Eigen::Isometry3d hand_pose(HandConvention convention, const Gripper& gripper,
                                             const Eigen::Isometry3d& X_CG, double width);

/// The grasp X_CG of a hand's pose X_CH, the inverse of hand_pose().
QUADRILLE_EXPORT Eigen::Isometry3d grasp_of_hand(HandConvention convention, const Gripper& gripper,
                                                 const Eigen::Isometry3d& X_CH, double width);

}  // namespace quadrille
