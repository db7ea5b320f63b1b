#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The pose of a camera that stands still, as the command line has it.
struct CameraPoseArgument {
  /// Of the camera's frame K, z ahead and x along the rows of its image, in a fixed frame W.
  std::optional<Eigen::Isometry3d> X_WK;

  /// Adds --camera-pose; this must outlive the app.
  /// @param rival  the option that it excludes
  void add_to(CLI::App& app, const std::string& rival);
};

/// Where the sensor stood, as the command line has it.
struct FrameArguments {
  /// In the cloud's frame C [m]; over what the file says.
  std::optional<Eigen::Vector3d> viewpoint;
  /// Its fixed frame is C here.
  CameraPoseArgument camera;

  /// Adds --viewpoint and --camera-pose; this must outlive the app.
  void add_to(CLI::App& command);

  /// The frame to work in, as a pose in C: the camera's where it is known, as there the pixels lie
  /// in rows; else C itself.
  Eigen::Isometry3d working_frame() const;
  /// Sets the viewpoint of a cloud that is in the working frame.
  void place_viewpoint(PointCloud* cloud) const;
};

}  // namespace quadrille
