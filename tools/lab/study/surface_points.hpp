#pragma once

#include <Eigen/Core>
#include <vector>

#include "lab/physics/true_body.hpp"

namespace quadrille::study {

/// Points all over a true body, including sides that no camera saw, with outward normals.
struct SurfacePoints {
  std::vector<Eigen::Vector3d> p_C, n_C;
};

/// Samples a body's surface, including its flat ends if it has them.
/// @param spacing  largest distance between neighbours along a ring or a row [m]
SurfacePoints surface_points(const physics::TrueBody& body, double spacing);

}  // namespace quadrille::study
