#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lab/scene/scene.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::scoring {

/// A surface that is known to be in a cloud.
struct TrueSurface {
  int id = 0;
  /// Surfaces of one body have the same number.
  int body = 0;
  /// False for table, wall, caps and faces of boxes.
  bool curved = false;
  std::string type;
  Quadric Q_C;
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();
  /// Extent of the surface, in its own frame S [m].
  Eigen::AlignedBox3d box_S;
  /// Largest side of the surface, and the standard deviation of the depth at its position [m].
  double size = 0.0, sigma = 0.0;
  /// True if enough is visible for the surface to be required.
  bool evaluate = false;
};

/// A cloud with full ground truth.
struct Frame {
  std::string name;
  /// Name of the family, such as "hard", or "stereo kitchen" if the truth names a sensor.
  std::string family;
  PointCloud cloud;
  /// For each point the id of its surface (negative for none) and its true unit normal (zero for
  /// none).
  std::vector<int> labels;
  std::vector<Eigen::Vector3f> normals;
  std::vector<TrueSurface> surfaces;
  /// Factor of the depth noise, for scene::depth_noise().
  double noise = 1.0;
};

/// Turns a generated scene into a frame.
Frame frame_of(const scene::Scene& scene);

/// Reads a frame from OUT.ply with OUT.truth.json, OUT.labels and OUT.normals beside it, as
/// `quadrille scene --labels` writes them. If OUT.truth.json is missing, OUT.json is read, as
/// scenes with simulated sensors have it. Points that are not finite are left out.
/// @throws std::runtime_error naming the file that is missing or wrong
Frame read_frame(const std::string& ply_path);

}  // namespace quadrille::scoring
