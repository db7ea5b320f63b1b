#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "poses/camera_poses.hpp"
#include "process/runtime/poses/cloud_frame.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Poses of a cloud and of its results; the work is done in frame K, the camera's.
struct Placement {
  /// Pose of frame K in the cloud's frame C and in the frame R of the results.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity(), X_RK = Eigen::Isometry3d::Identity();
  /// Pose of frame K in the fixed frame, if the camera's pose is known.
  std::optional<Eigen::Isometry3d> X_WK;
  /// Name of R if it differs from C; otherwise empty.
  std::string frame;
  /// Why the camera's pose, although needed, is not known; empty if nothing is missing.
  std::string lack;

  /// Returns the name of the frame of the results.
  /// @param cloud_frame  name of C
  const std::string& frame_of_results(const std::string& cloud_frame) const {
    return frame.empty() ? cloud_frame : frame;
  }
};

/// Decodes a cloud in the unit of its frames, without colours, which no process needs.
bus::Decoded<bus::CloudMessage> decode_cloud(std::span<const std::byte> bytes,
                                             const CloudFrames& frames);

/// Returns the placement of a cloud whose camera had this pose.
Placement place(const CloudFrames& frames, const CameraPose& pose);

/// Returns a cloud in frame K, in which the sensor of a cloud given in W is the origin.
PointCloud in_camera_frame(const PointCloud& cloud, const Placement& placement,
                           const CloudFrames& frames);

}  // namespace quadrille
