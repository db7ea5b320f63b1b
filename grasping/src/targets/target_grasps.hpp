#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/deadline.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/refusal.hpp"
#include "space/collision.hpp"
#include "targets/target.hpp"

namespace quadrille {

/// What the grasps of one target are planned from. All that it refers to must outlive it.
struct TargetTask {
  const Target& target;
  const Gripper& gripper;
  const PlanOptions& options;
  const GraspQuery& query;
  const OccupancyGrid& space;
  const CollisionScene& scene;
  const Deadline& deadline;
  /// Where the sensor stood [m].
  Eigen::Vector3d viewpoint_C;
};

/// The grasps of one target that survive, diverse, in no order, and what was refused.
struct TargetGrasps {
  std::vector<Grasp> grasps;
  RefusalCounts refusals;
  /// True if the deadline ended the search.
  bool cut = false;
};

/// Grasps across the whole body.
TargetGrasps grasps_across(const TargetTask& task);

/// Grasps by the tips, wherever these reach: a longer search, for where nothing else is to be had.
TargetGrasps grasps_by_tips(const TargetTask& task);

/// Grasps across the wall of its shell, at the rim.
TargetGrasps grasps_at_rim(const TargetTask& task);

}  // namespace quadrille
