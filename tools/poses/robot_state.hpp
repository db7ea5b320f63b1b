#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "poses/placement.hpp"
#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille {

/// The robot's shapes at one time, as a message or the command line says.
struct RobotState {
  /// When they were so [us]; 0: always.
  std::int64_t utime = 0;
  /// Name of the frame of the shapes, see pose_of_camera().
  std::string frame;
  RobotShapes robot;
  /// Shapes that are fixed to the hand, in its frame G.
  std::vector<SolidShape> attached;

  /// Returns the robot's shapes in frame K of a cloud.
  /// @param cloud_frame  name of the cloud's frame
  /// @throws std::invalid_argument if the frame of the shapes is not known
  RobotShapes in_camera_frame(const Placement& placement, const std::string& cloud_frame) const;
};

/// Returns all shapes of two robots, such as those of the command line and of a message, with the
/// larger padding.
RobotShapes joined(RobotShapes a, const RobotShapes& b);

/// Decodes a message of type quadrille.robot_t; it is refused if a shape is no solid.
bus::Decoded<RobotState> decode_robot_state(std::span<const std::byte> bytes);

}  // namespace quadrille
