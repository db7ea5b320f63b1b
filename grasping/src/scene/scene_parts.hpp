#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/deadline.hpp"
#include "quadrille/detector/box.hpp"
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
  RefusalCounts refusals;
  std::shared_ptr<const OccupancyGrid> space;
  /// The map refers to space and view, so all three must keep their addresses.
  std::optional<ObstacleMap> map;
  std::vector<std::string> warnings;
  std::vector<StageTime> timings;
};

/// Prepares a cloud stage by stage: boxes, shapes, view, targets, occupancy. Once the deadline has
/// passed, no further targets are chosen.
std::unique_ptr<const SceneParts> make_scene_parts(
    const PointCloud& cloud, const std::vector<Detection>& detections, const Gripper& gripper,
    const PlanOptions& options, const std::vector<PointCloud>& further, const Deadline& deadline);

}  // namespace quadrille
