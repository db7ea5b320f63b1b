#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  /// Indices of the vertices, counterclockwise as seen from the side to which the gradient points.
  std::vector<std::array<int, 3>> triangles;
};

/// Meshes the part of any quadric that lies in a box by marching tetrahedra. Each edge that the
/// surface crosses once gives one vertex, which lies on the surface.
/// @param cells  number of cells along the longest side of the box
TriangleMesh mesh_in_box(const Quadric& Q, const Eigen::AlignedBox3d& box, int cells);

}  // namespace quadrille
