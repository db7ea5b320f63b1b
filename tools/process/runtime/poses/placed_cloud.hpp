#pragma once

#include <cstddef>
#include <span>

#include "poses/camera_poses.hpp"
#include "poses/placement.hpp"
#include "process/runtime/poses/cloud_frames.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Decodes a cloud in the unit of its frames, without colours, which no process needs.
bus::Decoded<bus::CloudMessage> decode_cloud(std::span<const std::byte> bytes,
                                             const CloudFrames& frames);

/// Returns the placement of a cloud whose camera had this pose.
Placement place(const CloudFrames& frames, const CameraPose& pose);

/// Returns a cloud in frame K, in which the sensor of a cloud given in W is the origin.
PointCloud in_camera_frame(const PointCloud& cloud, const Placement& placement,
                           const CloudFrames& frames);

}  // namespace quadrille
