#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/plan_options.hpp"

namespace quadrille {

/// Proposes views that would help the bodies of which a plan has no grasp, or only one that is
/// doubtful.
///
/// About each such body, and about the place between all of them, places above the support are
/// tried, as far away as the sensor was, but between 0.35 and 0.75 m, where depth cameras measure
/// well, and on the side of each wall from which that was seen. A place shows those unknown voxels
/// within a finger's reach of a body to which the line of sight is free: it crosses no occupied
/// voxel and no body. How likely the view gives the body a grasp, or a sure one in place of a
/// doubtful one, follows from the share of these, from the least angle to a view that there is
/// already, from the height of the place, and from what refused the body's grasps. A view helps a
/// body without a grasp if it gives one with a probability of a third or more, and a body with a
/// doubtful grasp if it makes that sure with a probability of a half or more. Views that help
/// bodies without a grasp are chosen first, and among them that from which most first grasps are
/// expected; the next ones are for the bodies that are left.
/// @param plan        a plan in frame C, with the space that it mapped
/// @param bodies      the bodies of the plan
/// @param detections  the detections of the plan, among which are the supports of the bodies
/// @param gripper     the hand of the plan
/// @param options     those of the plan
/// @param viewpoints_C where the sensor was, for the plan's cloud first and then for further views
///                    [m]; see viewpoints_of()
/// @param max_looks   largest number of views
/// @return first those that help bodies without a grasp, and of both kinds those with the largest
///         gain first; empty if no view is likely to help
/// @throws std::invalid_argument if there is no viewpoint
QUADRILLE_EXPORT std::vector<Look> propose_looks(const GraspPlan& plan,
                                                 const std::vector<SceneBody>& bodies,
                                                 const std::vector<Detection>& detections,
                                                 const Gripper& gripper, const PlanOptions& options,
                                                 const std::vector<Eigen::Vector3d>& viewpoints_C,
                                                 int max_looks = 3);

}  // namespace quadrille
