#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <utility>

#include "hand/oriented_box.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "space/obstacle_map.hpp"

namespace quadrille {

/// The occupied voxels of a map from elsewhere, in the map's own frame M.
///
/// The voxels of a plan tell which of them have their middles there, but not where these voxels
/// end, if the lattices differ. A hand that keeps off the plan's voxels may still touch the corner
/// of one of the map's, which this finds.
class TurnedMap {
 public:
  /// @param plan  the voxels of the plan, in frame C
  /// @param robot_C  nothing is occupied where the robot's own shapes are
  /// @return nullopt if there is no map, its lattice is that of the plan, or it is too fine
  static std::optional<TurnedMap> of(const KnownMap& map, const OccupancyGrid& plan,
                                     const RobotShapes& robot_C);

  /// True if the map has more voxels in the region of a plan than a grid may have. Then hands keep
  /// off the plan's voxels alone.
  static bool is_too_fine(const KnownMap& map, const OccupancyGrid& plan);

  /// Copies the part of the map about a region.
  TurnedMap within(const Eigen::AlignedBox3d& region_C) const;
  /// Frees the voxels with their middles where the voxels of a plan are not occupied, such as those
  /// that gave way to a target.
  void follow(const ObstacleMap& plan_C);
  /// True if a box overlaps an occupied voxel.
  bool meets(const OrientedBox& box_C) const;

 private:
  TurnedMap(ObstacleMap voxels_M, const Eigen::Isometry3d& X_MC)
      : voxels_M_(std::move(voxels_M)), X_MC_(X_MC) {}

  ObstacleMap voxels_M_;
  Eigen::Isometry3d X_MC_;
};

}  // namespace quadrille
