#include "quadrille/robot_of_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "quadrille/bus/scene_messages.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

/// Returns the pose of the camera's frame K in a frame that a message names, as the processes do.
Eigen::Isometry3d camera_in(const std::string& frame, const std::string& cloud_frame, bool in_world,
                            bool has_world, const Eigen::Isometry3d& X_CK) {
  if (frame.empty()) return X_CK;
  if (frame == "camera") return Eigen::Isometry3d::Identity();
  if (frame == "world" && has_world) return X_CK;
  if (frame == cloud_frame) {
    return in_world ? Eigen::Isometry3d(Eigen::Isometry3d::Identity()) : X_CK;
  }
  if (frame == "world") {
    throw std::invalid_argument(
        "frame 'world' is not known without --pose-channel or --camera-pose");
  }
  throw std::invalid_argument(
      fmt::format("frame '{}' is not known: it may be 'camera', 'world', '{}' or ''",
                  printable(frame), printable(cloud_frame)));
}

}  // namespace

void place_robot(const robot_t& message, const std::string& cloud_frame, bool in_world,
                 bool has_world, InputCloud* input) {
  RobotShapes robot;
  robot.padding = message.padding;
  for (const collision_shape_t& shape : message.shapes) {
    robot.shapes.push_back(bus::from_message(shape));
  }
  robot.check();
  for (const collision_shape_t& shape : message.attached) {
    input->attached.push_back(bus::from_message(shape));
  }
  if (robot.shapes.empty()) return;
  const Eigen::Isometry3d X_FK =
      camera_in(message.frame, cloud_frame, in_world, has_world, input->X_CK);
  input->robot = moved(std::move(robot), X_FK.inverse());
}

RobotShapes joined(RobotShapes a, const RobotShapes& b) {
  if (b.shapes.empty()) return a;
  if (a.shapes.empty()) return b;
  a.shapes.insert(a.shapes.end(), b.shapes.begin(), b.shapes.end());
  a.padding = std::max(a.padding, b.padding);
  return a;
}

}  // namespace quadrille
