#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The pose of a static camera from the command line.
struct CameraPoseArgument {
  /// Pose of the camera's frame K (z forward, x along the rows of its image) in a fixed frame W.
  std::optional<Eigen::Isometry3d> X_WK;

  /// Adds --camera-pose; this object must outlive the app.
  /// @param rival  an option that cannot be given together with it
  void add_to(CLI::App& app, const std::string& rival);
};

/// The sensor's position from the command line.
struct FrameArguments {
  /// Position in the cloud's frame C [m]; overrides that of the file.
  std::optional<Eigen::Vector3d> viewpoint;
  /// Pose of the camera; its fixed frame W is C here.
  CameraPoseArgument camera;

  /// Adds --viewpoint and --camera-pose; this object must outlive the app.
  void add_to(CLI::App& command);

  /// Returns the pose in C of the frame in which to work: the camera's frame if it is known,
  /// because there the pixels lie in rows; otherwise C itself.
  Eigen::Isometry3d working_frame() const;
  /// Sets the viewpoint of a cloud given in the working frame.
  void place_viewpoint(PointCloud* cloud) const;
};

}  // namespace quadrille
