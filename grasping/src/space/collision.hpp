#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "hand/hand.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "space/obstacle_map.hpp"
#include "space/obstacle_points.hpp"
#include "space/turned_map.hpp"

namespace quadrille {

/// A plane that the target stands on. Within its extent, no hand goes below it.
struct SupportPlane {
  /// Frame P: origin in the plane, z along its normal.
  Eigen::Isometry3d X_CP = Eigen::Isometry3d::Identity();
  /// Extent of the plane, along x and y of P [m].
  Eigen::AlignedBox2d extent_P;
  /// The part of the extent in which the plane was seen, or is known to be; empty if none is [m].
  Eigen::AlignedBox2d seen_P = {};
  /// Root mean square of the distances of the plane's points from it [m].
  double rms = 0.0;
  /// True if voxels near the plane gave way to it (free_supports()), so that only the plane itself
  /// holds hands off what is lower than flatness().
  bool gave_way = false;

  Eigen::Vector3d n_C() const { return X_CP.linear().col(2); }
  double distance(const Eigen::Vector3d& p_C) const { return n_C().dot(p_C - X_CP.translation()); }
  /// Returns the height above the plane up to which its own points may lie, so that nothing tells
  /// them from something flat that lies on it [m]. No hand may come nearer to the plane.
  double flatness() const;
  /// Returns true if a part of the box may lie less than `margin` [m] above the plane within its
  /// extent. The test is conservative: it uses the bounds of the box along the axes of P.
  bool meets(const OrientedBox& box, double margin) const;
};

/// Clearances are measured up to this value [m].
inline constexpr double kMaxClearance = 0.032;

/// The kinds of things that stop a hand.
enum class Obstruction {
  kSupport,    ///< a plane that the target stands on
  kTarget,     ///< the target itself, including its hidden side
  kNeighbour,  ///< the shape of another detection
  kOccupied,   ///< a voxel with points, or a point
  kUnknown,    ///< a voxel that was not observed
};

/// Everything that a hand may run into on its way to one target.
struct CollisionScene {
  ObstacleMap map;
  std::vector<SupportPlane> planes;
  std::vector<CollisionShape> neighbours;
  /// The target's own body as convex pieces.
  std::vector<CollisionShape> target;
  /// Measured points about the target, where voxels gave way to them.
  ObstaclePoints points = {};
  /// The measured points about the target that belong to other things.
  ObstaclePoints other_points = {};
  /// The voxels of a map from elsewhere, in its own frame.
  std::optional<TurnedMap> known_map = {};
  /// Distance to keep from shapes and planes, which are known only as accurately as they were
  /// fitted; from planes it is more if their flatness() is [m].
  double margin = 0.002;
  /// Distance that the palm keeps from the target [m], since detections end short of the outermost
  /// points and the hand may come from any side of that end. It is smaller if the end was measured.
  double end_doubt = 0.008;

  /// Returns what the swept palm runs into, which no other opening of the hand avoids; nullopt if
  /// nothing. The palm keeps a distance of end_doubt from the target.
  std::optional<Obstruction> palm_obstruction(const OrientedBox& palm) const;
  /// Returns what the swept palm, or a thing that is fixed to the hand, runs into; nullopt if
  /// nothing.
  std::optional<Obstruction> back_obstruction(const SweptHand& hand) const;
  /// Returns what the swept fingers or their closing run into; closing, they may touch the target.
  std::optional<Obstruction> finger_obstruction(const SweptHand& hand) const;
  /// Returns what blocks the space that the fingers fill at the end of the approach, whatever their
  /// opening; the target is no obstacle to it.
  std::optional<Obstruction> closing_obstruction(const std::array<OrientedBox, 2>& fingers) const;
  /// Returns how far the hand may be inflated before it runs into anything other than the target;
  /// found by bisection to within 1 mm, at most kMaxClearance [m].
  double clearance(const SweptHand& hand) const;
};

/// Returns false if the shape certainly lies outside the region.
bool may_reach(const CollisionShape& shape, const Eigen::AlignedBox3d& region_C);

/// Returns true if the box and the shape overlap, or are only some micrometres apart.
bool overlaps(const OrientedBox& box, const CollisionShape& shape);

}  // namespace quadrille
