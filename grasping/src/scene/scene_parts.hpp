#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/deadline.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/refusal.hpp"
#include "space/obstacle_map.hpp"
#include "targets/target.hpp"
#include "targets/target_scene.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// A cloud prepared for grasp queries, with all that the queries need.
struct SceneParts {
  SceneParts() = default;
  SceneParts(const SceneParts&) = delete;
  SceneParts& operator=(const SceneParts&) = delete;

  Gripper gripper;
  PlanOptions options;
  Eigen::Vector3d viewpoint_C;
  /// Distance that the hand reaches from a target's surface [m].
  double reach = 0.0;
  std::vector<Box> boxes;
  std::vector<CollisionShape> shapes;
  /// Owner of each shape.
  std::vector<ShapeOwner> owners;
  std::optional<DepthView> view;
  std::vector<Target> targets;
  /// Why other detections and boxes are not targets, by id: "is a plane".
  std::map<int, std::string> why_none;
  /// Ids of the detections and boxes for which there was no time.
  std::vector<int> late;
  RefusalCounts refusals;
  /// Null if there was no time to map it.
  std::shared_ptr<const OccupancyGrid> space;
  /// The map refers to space and view, so all three must keep their addresses.
  std::optional<ObstacleMap> map;
  std::vector<std::string> warnings;
  std::vector<StageTime> timings;
};

/// Prepares a cloud stage by stage: boxes, shapes, view, targets, occupancy. Targets are chosen
/// within half of the deadline [ms], which leaves the other half to try them; 0 means no deadline.
/// If all of it has passed by then, no target is left and space is not mapped.
std::unique_ptr<const SceneParts> make_scene_parts(
    const PointCloud& cloud, const std::vector<Detection>& detections, const Gripper& gripper,
    const PlanOptions& options, const std::vector<PointCloud>& further, double deadline_ms);

}  // namespace quadrille
