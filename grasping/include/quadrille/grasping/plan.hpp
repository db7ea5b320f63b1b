#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/refusal.hpp"

namespace quadrille {

/// What the planner made of one cloud and its quadrics.
struct GraspPlan {
  /// Best first.
  std::vector<Grasp> grasps;
  /// How much was refused, by the name of its Refusal; reasons that did not occur are left out.
  std::map<std::string, int> rejected;
  /// The boxes that planes among the detections are faces of; each may be a target.
  std::vector<Box> boxes;
  /// Of all boxes, and of all detections that have any and are no faces of boxes; those of one
  /// detection in a row.
  std::vector<CollisionShape> shapes;
  /// Free, occupied and unknown space around the targets; to_octree() makes an OctoMap of it.
  std::shared_ptr<const OccupancyGrid> space;
  std::vector<StageTime> timings;
  double total_ms = 0.0;
  std::vector<std::string> warnings;
};

/// Plans two-finger grasps on the detections of one cloud.
///
/// Contacts follow in closed form from each quadric, and for boxes (see find_boxes()) lie across
/// their parallel faces; the hand, swept along its approach and while
/// it closes, is checked against the voxels, the planes and the shapes of all other detections, and
/// its opened fingers and palm against the target's own body. Deterministic, unless a deadline cuts
/// it short: then it has the grasps that were found in time, and a warning.
/// @param further  more views of the same scene at rest, in the same frame C, each with its own
///                 viewpoint: what they show free or occupied is so
/// @param query    which grasps are wanted; to ask more than once, see GraspScene
/// @throws std::invalid_argument if gripper, options or query are out of range
QUADRILLE_EXPORT GraspPlan plan_grasps(const PointCloud& cloud,
                                       const std::vector<Detection>& detections,
                                       const Gripper& gripper, const PlanOptions& options = {},
                                       const std::vector<PointCloud>& further = {},
                                       const GraspQuery& query = {});

}  // namespace quadrille
