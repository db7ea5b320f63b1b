#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace quadrille {

/// Points of a surface, thinned to one for each small cell, with its normals.
struct SurfacePoints {
  /// Positions in frame C [m].
  std::vector<Eigen::Vector3d> p_C;
  /// Unit normals towards the sensor; zero where there are too few points for one.
  std::vector<Eigen::Vector3d> n_C;
};

/// Thins points to the mean of those in each cell, and takes the normals from the neighbours of
/// each mean by principal components. Where one sensor's points end and another's begin there is a
/// step that is no surface, because their views are a little off; so each mean and each normal is
/// taken from one sensor's points. The order of the result depends on the positions and the sensors
/// alone.
/// @param points_C  positions, in frame C [m]
/// @param cell  edge of a cell [m]; normals are taken over some three cells around a point
/// @param eyes_C  for each point, the position of the sensor that saw it [m]
SurfacePoints surface_points(std::span<const Eigen::Vector3d> points_C, double cell,
                             std::span<const Eigen::Vector3d> eyes_C);

}  // namespace quadrille
