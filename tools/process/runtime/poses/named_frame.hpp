#pragma once

#include <Eigen/Geometry>
#include <string>

#include "process/runtime/poses/placement.hpp"

namespace quadrille {

/// Returns the pose of frame K, the camera's when it took a cloud, in the frame that a message
/// names: "camera", "world", the name of the cloud's frame, or "" for the frame of the results.
/// @param cloud_frame  name of the cloud's frame
/// @throws std::invalid_argument if the frame or the pose is not known; the message says which
Eigen::Isometry3d pose_of_camera(const std::string& frame, const Placement& placement,
                                 const std::string& cloud_frame);

}  // namespace quadrille
