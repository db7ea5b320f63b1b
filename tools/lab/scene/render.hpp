#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lab/scene/camera.hpp"
#include "lab/scene/surface.hpp"

namespace quadrille::scene {

/// What an ideal depth camera sees; images row by row.
struct Rendering {
  /// Depth along z [m]; 0 where there is nothing.
  std::vector<double> depth;
  /// Index of the surface, counted over all bodies; -1 where there is nothing.
  std::vector<int> surface;
  /// Unit normals in frame C, towards the camera.
  std::vector<Eigen::Vector3f> normal;
  /// For each surface its visible pixels, and those it would have without the other bodies.
  std::vector<int> visible, alone;
};

/// Casts one ray per pixel, in closed form.
Rendering render(const Camera& camera, const std::vector<Body>& bodies,
                 const Eigen::Isometry3d& X_CW);

}  // namespace quadrille::scene
