#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/quadric_type.hpp"

namespace quadrille {

/// A box in which things are looked for.
struct Region {
  /// Pose of its frame R.
  Eigen::Isometry3d X_CR = Eigen::Isometry3d::Identity();
  Eigen::AlignedBox3d box_R;
};

/// Directions within an angle of one.
struct Cone {
  /// Unit direction.
  Eigen::Vector3d axis_C = Eigen::Vector3d::UnitZ();
  /// Largest angle to it [rad].
  double half_angle = std::numbers::pi;

  bool contains(const Eigen::Vector3d& direction_C) const {
    const double angle = std::atan2(direction_C.cross(axis_C).norm(), direction_C.dot(axis_C));
    return angle <= half_angle;
  }
};

/// Which grasps are wanted, of all that the planner could find. What is not wanted stays in the
/// way. All conditions hold at once; as made, it asks for everything. Conditions on approach and
/// clearance guide the search, which may then find others than without them.
struct GraspQuery {
  static constexpr double kMaxMinClearance = 0.03;

  /// Ids of detections and boxes, and tracks; empty means all.
  std::vector<int> ids, tracks;
  /// Types; empty means all. Boxes are planes.
  std::vector<QuadricType> types;
  /// Where the middle of a target lies.
  std::optional<Region> region;
  /// Longest side of a target, in its own frame [m].
  double min_size = 0.0, max_size = std::numeric_limits<double>::infinity();
  /// Only that of all these targets that is nearest to this point [m].
  std::optional<Eigen::Vector3d> near_C;
  /// Where the hand may come along: directions of its approach.
  std::optional<Cone> approach;
  /// Distance of the hand from all but its target, on its way and at its end [m]; at most
  /// kMaxMinClearance, as far as clearances are measured.
  double min_clearance = 0.0;
  /// Grasps to return at most, over PlanOptions::max_grasps.
  std::optional<int> max_grasps;
  /// Time after which the plan ends with the grasps that it has [ms], in place of
  /// PlanOptions::deadline_ms; 0: none.
  std::optional<double> deadline_ms;

  /// True if it asks for some targets alone.
  QUADRILLE_EXPORT bool selects() const;

  /// @throws std::invalid_argument that names the field which is out of range, and the remedy
  QUADRILLE_EXPORT void check() const;
};

/// A query of frame C in frame F.
QUADRILLE_EXPORT GraspQuery moved(GraspQuery query, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
