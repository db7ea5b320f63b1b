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
  /// False for table, wall, caps and faces of boxes.
  bool curved = false;
  std::string type;
  Quadric Q_C;
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();
  /// What there is of it, in its own frame S [m].
  Eigen::AlignedBox3d box_S;
  /// Largest extent, and standard deviation of the depth where it stands [m].
  double size = 0.0, sigma = 0.0;
  /// Seen well enough to be asked for.
  bool evaluate = false;
};

/// A cloud of which all is known.
struct Frame {
  std::string name;
  /// Such as "hard", or "stereo kitchen" where the truth names a sensor.
  std::string family;
  PointCloud cloud;
  /// Per point the id of its surface, negative for none, and its true unit normal, zero for none.
  std::vector<int> labels;
  std::vector<Eigen::Vector3f> normals;
  std::vector<TrueSurface> surfaces;
  /// Factor of the depth noise, for scene::depth_noise().
  double noise = 1.0;
};

/// A generated scene as a frame.
Frame frame_of(const scene::Scene& scene);

/// A frame from files: OUT.ply with OUT.truth.json, OUT.labels and OUT.normals beside it, as
/// `quadrille scene --labels` writes them. Without OUT.truth.json OUT.json is taken, as scenes of
/// sensors have it. Points that are not finite are left out.
/// @throws std::runtime_error naming the file that is missing or wrong
Frame read_frame(const std::string& ply_path);

}  // namespace quadrille::scoring
