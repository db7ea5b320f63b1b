#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "base/deadline.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/refusal.hpp"
#include "space/collision.hpp"
#include "targets/scene_parts.hpp"
#include "targets/target.hpp"
#include "targets/target_points.hpp"

namespace quadrille {

/// The inputs for planning the grasps of one target. Everything that it refers to must outlive it.
struct TargetTask {
  const SceneParts& parts;
  /// The query, completed() by the options.
  const GraspQuery& query;
  const Deadline& deadline;
  const Target& target;
  /// The obstacles around the target.
  const CollisionScene& scene;
  /// The grasps that other searches found on the target, to which those of this search must be
  /// unlike.
  std::vector<Grasp> others = {};
  /// Boxes around what is fixed to the hand, in frame G [m].
  std::span<const Eigen::AlignedBox3d> attached_G = {};
};

/// The diverse grasps of one target that survive, in no particular order, and the refusals.
struct TargetGrasps {
  std::vector<Grasp> grasps;
  RefusalCounts refusals;
  /// Number of candidates that were not tried, since they would score too little even with nothing
  /// in their way.
  int unlikely = 0;
  /// True if the deadline ended the search early.
  bool cut = false;
};

/// Finds grasps across the whole body.
TargetGrasps grasps_across(const TargetTask& task);

/// Finds grasps by the tips, wherever they reach. The search takes longer, and is for targets that
/// have no other grasp, or too few.
TargetGrasps grasps_by_tips(const TargetTask& task);

/// Finds grasps between the outermost points of a target, which needs no shape of it.
TargetGrasps grasps_by_points(const TargetTask& task, const TargetPoints& points);

/// Finds grasps across the wall of the target's shell, at the rim.
TargetGrasps grasps_at_rim(const TargetTask& task);

}  // namespace quadrille
