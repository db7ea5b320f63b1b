#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Proposes views that would help the bodies of which a plan has no grasp, or only one that is
/// doubtful.
///
/// About each such body, places above its support are tried, as far from it as the sensor was, but
/// between 0.35 and 0.9 m, where depth cameras measure well, and on the side of each wall from
/// which that was seen. The unknown voxels within a finger's reach of the body are what the hand
/// needs to know. A place shows those of them to which the line of sight is free: it crosses no
/// occupied voxel and no body. The place that shows most comes first. The next ones are for the
/// bodies that it does not help.
/// @param plan        a plan in frame C, with the space that it mapped
/// @param bodies      the bodies of the plan
/// @param detections  the detections of the plan, among which are the supports of the bodies
/// @param viewpoint_C where the sensor was [m]
/// @param max_looks   largest number of views
/// @return views with the largest gain first; empty if no body lacks a grasp, or nothing is unknown
QUADRILLE_EXPORT std::vector<Look> propose_looks(const GraspPlan& plan,
                                                 const std::vector<SceneBody>& bodies,
                                                 const std::vector<Detection>& detections,
                                                 const Eigen::Vector3d& viewpoint_C,
                                                 int max_looks = 3);

}  // namespace quadrille
