#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// A piece of surface as triangles, in the frame Q of its detection [m].
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Edges at which the piece ends.
  std::vector<std::array<std::uint32_t, 2>> rims;
};

/// Returns the place at which a quadric crosses the line between two points on different sides of
/// it: 0 at p, 1 at q.
double crossing_between(const Quadric& Q, const Eigen::Vector3d& p, const Eigen::Vector3d& q);

/// Meshes the surface of a quadric within the extent of its inliers. Each vertex lies on the
/// quadric, up to rounding. Empty for a detection without extent or with numbers that are not
/// finite.
/// @param cells  number of cells along each axis of the extent
Mesh mesh_of(const Detection& detection, int cells = 20);

/// Returns the convex outline of points on a plane, as a fan of triangles; empty if they lie on a
/// line.
/// @param points_Q  positions in the plane [m]
Mesh mesh_of_outline(std::vector<Eigen::Vector2d> points_Q);

}  // namespace quadrille
