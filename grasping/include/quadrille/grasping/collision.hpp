#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "quadrille/grasping/hand.hpp"
#include "quadrille/grasping/obstacle_map.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille {

/// A plane that bounds free space: n·x ≥ d holds for all that may be entered.
struct SupportPlane {
  Eigen::Vector3d n_C = Eigen::Vector3d::UnitZ();
  double d = 0.0;

  double distance(const Eigen::Vector3d& p_C) const { return n_C.dot(p_C) - d; }
};

/// What stops a hand.
enum class Obstruction {
  kSupport,    ///< a plane that the target stands on or before
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

  /// What the swept hand runs into, nullopt if nothing. Its closing may touch the target.
  std::optional<Obstruction> obstruction(const SweptHand& hand) const;
  /// The same for the palm alone, which no other opening of the hand moves out of the way.
  std::optional<Obstruction> palm_obstruction(const SweptHand& hand) const;
  /// The same for the fingers and their closing.
  std::optional<Obstruction> finger_obstruction(const SweptHand& hand) const;
  /// How far the hand may be inflated before it runs into anything but the target, found by
  /// bisection to within 1 mm and at most 32 mm [m].
  double clearance(const SweptHand& hand) const;
};

/// True if the box and the shape overlap.
bool overlaps(const OrientedBox& box, const CollisionShape& shape);

/// FCL's own test of a box against the occupied cells of an octree: the reference for ObstacleMap.
bool overlaps(const OrientedBox& box, const std::shared_ptr<const octomap::OcTree>& tree);

}  // namespace quadrille
