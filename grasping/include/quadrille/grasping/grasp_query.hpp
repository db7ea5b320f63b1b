#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/reach.hpp"

namespace quadrille {

/// A box that limits the search for targets.
struct Region {
  /// Pose of the box's frame R in C.
  Eigen::Isometry3d X_CR = Eigen::Isometry3d::Identity();
  Eigen::AlignedBox3d box_R;
};

/// All directions within an angle of an axis.
struct Cone {
  /// Unit direction of the axis.
  Eigen::Vector3d axis_C = Eigen::Vector3d::UnitZ();
  /// Largest angle between a direction and the axis [rad].
  double half_angle = std::numbers::pi;

  bool contains(const Eigen::Vector3d& direction_C) const {
    const double angle = std::atan2(direction_C.cross(axis_C).norm(), direction_C.dot(axis_C));
    return angle <= half_angle;
  }
};

/// Selects which of all possible grasps are wanted. Objects that are not selected remain obstacles.
/// All conditions must hold at once; the default asks for everything. The conditions on approach,
/// reach and clearance, and accept, also guide the search, which may therefore find grasps that a
/// plain search does not.
struct GraspQuery {
  static constexpr double kMaxMinClearance = 0.03;

  /// Ids of detections, boxes and bodies, and ids of tracks; if both are empty, all targets are
  /// wanted. The id of a body asks for all its parts as one target, the id of one of its other
  /// parts for that part alone.
  std::vector<int> ids, tracks;
  /// Quadric types of the targets; empty means all. Boxes count as planes.
  std::vector<QuadricType> types;
  /// The centre of a target must lie in this region.
  std::optional<Region> region;
  /// Bounds on the longest side of a target, in its own frame [m].
  double min_size = 0.0, max_size = std::numeric_limits<double>::infinity();
  /// Keeps only the target that is nearest to this point [m].
  std::optional<Eigen::Vector3d> near_C;
  /// Directions from which the hand may approach.
  std::optional<Cone> approach;
  /// Only grasps to which the arm can bring the hand; overrides PlanOptions::reach.
  std::optional<Reach> reach;
  /// Shapes that the hand must not touch, besides what the cloud shows: of the robot, of a fence,
  /// of what the camera does not see. Made by with_geometry(); the field `target` is ignored.
  std::vector<CollisionShape> obstacles;
  /// Shapes that are fixed to the hand, in its frame G, such as a camera on the wrist or an object
  /// that another finger holds: they must not touch anything on the way in and at the grasp. Made
  /// by with_geometry(). The sides of a box around each, along the axes of G, are what counts.
  std::vector<CollisionShape> attached;
  /// Least distance between the hand and everything but its target, on the way in and at the grasp
  /// [m]. At most kMaxMinClearance, because larger clearances are not measured.
  double min_clearance = 0.0;
  /// Least score of a grasp, 0 to 1; overrides PlanOptions::min_score.
  std::optional<double> min_score;
  /// Largest number of grasps of each target, see PlanOptions::per_target, which it overrides.
  std::optional<int> per_target;
  /// Largest number of grasps to return; overrides PlanOptions::max_grasps.
  std::optional<int> max_grasps;
  /// Time after which the plan ends with the grasps found so far [ms]; overrides
  /// PlanOptions::deadline_ms. 0 means no deadline.
  std::optional<double> deadline_ms;
  /// If set, it is called for each grasp that has passed all other checks, before the grasp counts
  /// towards any number of grasps; false refuses the grasp (Refusal::kCaller), and the search goes
  /// on. A motion planner can say here which poses the arm can take. The grasp is in the frame of
  /// the query. The calls come one after the other, from the thread that called plan(), in an order
  /// that is always the same for the same input, and their time counts towards the deadline. An
  /// exception ends the plan and passes through it. Of accepted grasps that are alike on two parts
  /// of a body only the better one is given.
  std::function<bool(const Grasp&)> accept;

  /// Returns true if the query asks for some targets only.
  QUADRILLE_EXPORT bool selects() const;

  /// @throws std::invalid_argument naming the field that is out of range, and the remedy
  QUADRILLE_EXPORT void check() const;
};

/// Transforms a query from frame C into frame F. Its accept() still gets grasps in frame C.
QUADRILLE_EXPORT GraspQuery moved(GraspQuery query, const Eigen::Isometry3d& X_FC);

/// Sets what a query leaves open, and the options decide, as the options say: reach, score, numbers
/// of grasps and deadline. The position of the arm's base must be in the frame of the query.
/// @throws std::invalid_argument if the options are out of range
QUADRILLE_EXPORT GraspQuery completed(GraspQuery query, const PlanOptions& options);

}  // namespace quadrille
