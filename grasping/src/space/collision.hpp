#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "hand/hand.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "space/obstacle_map.hpp"

namespace quadrille {

/// A plane that the target stands on, as far as it reaches: no hand goes below it there.
struct SupportPlane {
  /// Frame P: origin in the plane, z along its normal.
  Eigen::Isometry3d X_CP = Eigen::Isometry3d::Identity();
  /// Where it reaches, along x and y of P [m].
  Eigen::AlignedBox2d extent_P;

  Eigen::Vector3d n_C() const { return X_CP.linear().col(2); }
  double distance(const Eigen::Vector3d& p_C) const { return n_C().dot(p_C - X_CP.translation()); }
  /// True if part of the box may lie less than `margin` [m] above the plane within its extent.
  /// Never false if it does: the box's bounds along the axes of P are what counts.
  bool meets(const OrientedBox& box, double margin) const;
};

/// No clearance is looked for beyond this [m].
inline constexpr double kMaxClearance = 0.032;

/// What stops a hand.
enum class Obstruction {
  kSupport,    ///< a plane that the target stands on
  kTarget,     ///< the target itself, hidden side included
  kNeighbour,  ///< the shape of another detection
  kOccupied,   ///< a voxel with points
  kUnknown,    ///< a voxel that was not observed
};

/// All that a hand may run into on its way to one target.
struct CollisionScene {
  ObstacleMap map;
  std::vector<SupportPlane> planes;
  std::vector<CollisionShape> neighbours;
  /// The target's own body as convex pieces.
  std::vector<CollisionShape> target;
  /// Distance to keep from shapes and planes, which are known only as well as their fit [m].
  double margin = 0.002;
  /// Distance that the palm keeps from the target [m]: detections end short of the outermost
  /// points, and the hand may come from any side of that end. Less where the end was measured.
  double end_doubt = 0.008;

  /// What the swept palm runs into, nullopt if nothing: no other opening of the hand moves it out
  /// of the way. It stays off the target by end_doubt.
  std::optional<Obstruction> palm_obstruction(const OrientedBox& palm) const;
  /// The same for the swept fingers and their closing, which may touch the target.
  std::optional<Obstruction> finger_obstruction(const SweptHand& hand) const;
  /// The same for what fingers fill at the end of the approach, whatever their opening: the target
  /// is no obstacle to it.
  std::optional<Obstruction> closing_obstruction(const std::array<OrientedBox, 2>& fingers) const;
  /// How far the hand may be inflated before it runs into anything but the target, found by
  /// bisection to within 1 mm and at most kMaxClearance [m].
  double clearance(const SweptHand& hand) const;
};

/// False if the shape lies beside the region, for certain.
bool may_reach(const CollisionShape& shape, const Eigen::AlignedBox3d& region_C);

/// True if the box and the shape overlap, or are but some micrometres apart.
bool overlaps(const OrientedBox& box, const CollisionShape& shape);

}  // namespace quadrille
