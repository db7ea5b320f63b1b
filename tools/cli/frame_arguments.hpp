#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "poses/placement.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// Reads a pose "X,Y,Z,QW,QX,QY,QZ" in metres, its quaternion of norm 1.
/// @throws CLI::ValidationError naming the option
Eigen::Isometry3d camera_pose_of(const std::string& option, const std::string& list);

/// The pose of a static camera from the command line.
struct CameraPoseArgument {
  /// Pose of the camera's frame K (z forward, x along the rows of its image) in a fixed frame W.
  std::optional<Eigen::Isometry3d> X_WK;

  /// Adds --camera-pose; this object must outlive the app.
  /// @param rival  an option that cannot be given together with it
  void add_to(CLI::App& app, const std::string& rival);
};

/// The sensor's position from the command line, and the unit of the clouds.
struct FrameArguments {
  /// Position in the cloud's frame C [m]; overrides that of the file.
  std::optional<Eigen::Vector3d> viewpoint;
  /// Pose of the camera; its fixed frame W is C here.
  CameraPoseArgument camera;
  /// The poses of the cameras of several inputs, in their order, if more than one pose is given.
  std::vector<Eigen::Isometry3d> cameras;
  /// Length of the unit of the clouds' coordinates [m].
  double unit = 1.0;

  /// Adds --viewpoint, --camera-pose and --unit; this object must outlive the app.
  void add_to(CLI::App& command);
  /// The same, with a pose for each input if it is given so often.
  void add_for_inputs_to(CLI::App& command);
  /// @throws CLI::ValidationError if there are several poses, but not as many as inputs
  void check(std::size_t inputs) const;
  /// Returns what holds for one of the inputs, counted from 0.
  FrameArguments of_input(std::size_t n) const;

  /// Returns the pose of the cloud's frame in the working frame, times the unit.
  Eigen::Affine3d from_file() const;
  /// Returns the pose in C of the frame in which to work: the camera's frame if it is known,
  /// because there the pixels lie in rows; otherwise C itself.
  Eigen::Isometry3d working_frame() const;
  /// Returns where the camera was; results are in C.
  Placement placement() const;
  /// Sets the viewpoint of a cloud given in the working frame.
  void place_viewpoint(PointCloud* cloud) const;
};

}  // namespace quadrille
