#pragma once

#include <Eigen/Core>

#include "quadrille/detector/body.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/plan_options.hpp"

namespace quadrille {

/// A prospect tells what further views may do for a body.
struct Prospect {
  /// Probability that there are views which give the body a grasp, or a sure one if it has a
  /// doubtful one. It is 0 for bodies that no view helps.
  double chance = 0.0;
  /// True if the body has a grasp, which a view could make sure.
  bool has_grasp = false;
};

/// Judges by the plan what further views may do for a body.
/// @param up_C  normal of the plane on which the body stands; zero if it is not known
Prospect prospect_of(const SceneBody& body, const GraspPlan& plan, const Gripper& gripper,
                     const PlanOptions& options, const Eigen::Vector3d& up_C);

/// Returns true if the hand may be able to close on a body from one side to the other: along a
/// direction in which a finger fits beside it, it is no wider than the hand opens, as far as its
/// size is known.
bool may_fit(const SceneBody& body, const Gripper& gripper, const PlanOptions& options,
             const Eigen::Vector3d& up_C);

/// Returns the probability that one view gives a body what the prospect says.
/// @param share  of the unknown space about the body that the view shows
/// @param angle  the least one between the lines of sight to the body of this view and of those
///               views that there are already [rad]
/// @param height  sine of the angle between the line of sight and the support
double chance_by_view(const Prospect& prospect, double share, double angle, double height);

}  // namespace quadrille
