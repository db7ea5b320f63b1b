#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/cloud_runs.hpp"
#include "base/deadline.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/refusal.hpp"
#include "space/obstacle_map.hpp"
#include "space/turned_map.hpp"
#include "targets/target.hpp"
#include "targets/target_surfaces.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// The detection or box that a collision shape belongs to.
struct ShapeOwner {
  /// Id of the detection or box.
  int id = 0;
  /// Centre and largest size of the owner [m].
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero();
  double size = 0.0;
};

/// Points of several views.
struct ViewedPoints {
  /// The space keeps them, too.
  std::shared_ptr<const std::vector<Eigen::Vector3f>> shared_C;
  std::span<const Eigen::Vector3f> p_C;
  /// For each point, the index of the view.
  std::vector<int> view;
  /// The points once more, to look at some of them.
  CloudRuns runs;
};

/// A cloud prepared for grasp queries, with all that the queries need.
struct SceneParts {
  SceneParts() = default;
  SceneParts(const SceneParts&) = delete;
  SceneParts& operator=(const SceneParts&) = delete;

  Gripper gripper;
  PlanOptions options;
  /// Distance that the hand reaches from a target's surface [m].
  double reach = 0.0;
  std::vector<Box> boxes;
  std::vector<CollisionShape> shapes;
  /// Owner of each shape.
  std::vector<ShapeOwner> owners;
  /// The views, the cloud's own first. The space keeps them, too.
  std::shared_ptr<const std::vector<DepthView>> shared_views;
  std::span<const DepthView> views;
  /// The points of all views around the targets, without strays.
  ViewedPoints points;
  std::vector<Target> targets;
  /// The measured surfaces of the targets and around them, without what the targets stand on.
  TargetSurfaces surfaces;
  /// The view that shows most of a target.
  const DepthView& view_of(const Target& target) const { return views[target.view]; }
  /// Why other detections and boxes are not targets, by id: "is a plane".
  std::map<int, std::string> why_none;
  /// The detections and boxes among these that are to be grasped but were refused, by id.
  std::map<int, Refusal> refused;
  /// Ids of the bodies of which detections are parts, by the ids of the detections.
  std::map<int, int> body_of;
  RefusalCounts refusals;
  /// Null if there was no time to map it.
  std::shared_ptr<const OccupancyGrid> space;
  /// The voxels of that space, including the targets' own. The map refers to the views, so both
  /// must keep their addresses.
  std::optional<ObstacleMap> map;
  /// The map from elsewhere, if its voxels are not those of the space.
  std::optional<TurnedMap> known_map;
  std::vector<std::string> warnings;
  std::vector<StageTime> timings;

  /// Refuses a detection or box as a target; only if it is wanted, this counts.
  void refuse(int id, Refusal why, bool wanted = true) {
    why_none[id] = "cannot be held: " + std::string(to_string(why));
    if (!wanted) return;
    ++refusals[why];
    refused.emplace(id, why);
  }
};

}  // namespace quadrille
