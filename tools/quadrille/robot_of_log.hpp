#pragma once

#include <lcmtypes/quadrille/robot_t.hpp>
#include <string>
#include <vector>

#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"
#include "quadrille/input_cloud.hpp"

namespace quadrille {

/// Sets the robot's shapes of a cloud of a log to those that a message tells.
/// @param input        the cloud, once its frames are known
/// @param cloud_frame  name of the frame in which the cloud was logged
/// @param in_world     whether results are in the fixed frame of the poses on a channel
/// @param has_world    whether the pose of the camera in a fixed frame is known
/// @throws std::invalid_argument if the message names a frame that is not known, or a shape is no
///   solid
void place_robot(const robot_t& message, const std::string& cloud_frame, bool in_world,
                 bool has_world, InputCloud* input);

/// Returns all shapes of two robots, such as those of the command line and of a log.
RobotShapes joined(RobotShapes a, const RobotShapes& b);

}  // namespace quadrille
