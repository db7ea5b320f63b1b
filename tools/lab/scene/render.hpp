#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lab/scene/camera.hpp"
#include "lab/scene/surface.hpp"

namespace quadrille::scene {

/// The images of an ideal depth camera, row by row.
struct Rendering {
  /// Depth along z [m]; 0 if the pixel sees nothing.
  std::vector<double> depth;
  /// Index of the surface, counted over all bodies; -1 if the pixel sees nothing.
  std::vector<int> surface;
  /// Unit normals in frame C, towards the camera.
  std::vector<Eigen::Vector3f> normal;
  /// Number of visible pixels of each surface, and of those visible without the other bodies.
  std::vector<int> visible, alone;
};

/// Renders the bodies by casting one ray per pixel, in closed form.
Rendering render(const Camera& camera, const std::vector<Body>& bodies,
                 const Eigen::Isometry3d& X_CW);

}  // namespace quadrille::scene
