#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lab/scene/scene.hpp"

namespace quadrille {

/// The file of a further view of a scene.
struct WrittenView {
  std::string path;
  /// Pose of its camera K in frame C of the first view, in which all files are.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity();
};

/// Writes a generated scene as one file for each of several views: OUT.ply with its ground truth,
/// as it is written alone, and OUT.view1.ply and so on from places up to 60 degrees to both sides,
/// with noise of their own.
/// @param views  number of views, at least 2
/// @return the further views
std::vector<WrittenView> write_scene_views(const std::string& path,
                                           const scene::SceneOptions& options, bool labels,
                                           int views, scene::Scene* first);

}  // namespace quadrille
