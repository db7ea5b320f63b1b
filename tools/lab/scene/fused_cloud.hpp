#pragma once

#include <Eigen/Core>
#include <vector>

#include "lab/scene/random.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::scene {

/// An object of a fused cloud, with exact points all over it.
struct FusedThing {
  QuadricType type = QuadricType::kSphere;
  /// Exact points on the surface [m].
  std::vector<Eigen::Vector3d> exact_C;
};

/// A cloud as if fused from many views: it has no image, and its points are in random order.
struct FusedCloud {
  PointCloud cloud;
  std::vector<FusedThing> things;
};

/// Makes spheres, cylinders and cones standing 30 cm apart on a table, which is z = 0 of frame C.
/// More than half of the points lie on the table, the others on the objects, all with Gaussian
/// noise of 1.2 mm along the normal. There are 12 objects up to 350,000 points; beyond that, the
/// table and the number of objects grow with the cloud.
/// @param points  number of points
FusedCloud make_fused_cloud(int points, Random* random);

}  // namespace quadrille::scene
