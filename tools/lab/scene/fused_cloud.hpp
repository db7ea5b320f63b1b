#pragma once

#include <Eigen/Core>
#include <vector>

#include "lab/scene/random.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/quadric_type.hpp"

namespace quadrille::scene {

/// A thing of a fused cloud, with exact points all over it.
struct FusedThing {
  QuadricType type = QuadricType::kSphere;
  /// [m]
  std::vector<Eigen::Vector3d> exact_C;
};

/// A cloud as fused from many views: no image, points in random order.
struct FusedCloud {
  PointCloud cloud;
  std::vector<FusedThing> things;
};

/// Spheres, cylinders and cones standing 30 cm apart on a table, the table z = 0 of frame C: over
/// half of the points on the table, the others on the things, all with Gaussian noise of 1.2 mm
/// along the normal. There are 12 things up to 350,000 points; from there on the table and the
/// number of things grow with the cloud.
/// @param points  number of points
FusedCloud make_fused_cloud(int points, Random* random);

}  // namespace quadrille::scene
