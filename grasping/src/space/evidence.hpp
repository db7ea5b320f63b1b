#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/surroundings.hpp"

namespace quadrille {

/// The points, map and shapes from which the occupied voxels of a grid were made. They tell which
/// voxels are occupied in another frame too. Taking over the state of all turned voxels that a
/// voxel overlaps would make surfaces three times as thick.
struct OccupancyGrid::Evidence {
  /// The points of all views in the grid, without strays, in frame C; null if there are none.
  std::shared_ptr<const std::vector<Eigen::Vector3f>> points_C;
  /// Further ones that are in the grid, but not in the region for which it was made.
  std::vector<Eigen::Vector3f> beside_C;
  /// A map from elsewhere, and the robot's own shapes, in which nothing is occupied.
  KnownMap map;
  RobotShapes robot;

  /// Makes those voxels of a grid in frame F occupied that would be so if it had been made of all
  /// this; what the other voxels are stays.
  void occupy(const Eigen::Isometry3d& X_FC, OccupancyGrid* grid) const;
};

}  // namespace quadrille
