#include "poses/robot_state.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "quadrille/bus/scene_messages.hpp"

namespace quadrille {

bus::Decoded<RobotState> decode_robot_state(std::span<const std::byte> bytes) {
  auto decoded = bus::decode_robot(bytes);
  if (auto* const refused = std::get_if<bus::Rejection>(&decoded)) return std::move(*refused);
  const robot_t& message = std::get<robot_t>(decoded);
  RobotState state{message.utime, message.frame, {{}, message.padding}, {}};
  try {
    for (const collision_shape_t& shape : message.shapes) {
      state.robot.shapes.push_back(bus::from_message(shape));
    }
    for (const collision_shape_t& shape : message.attached) {
      state.attached.push_back(bus::from_message(shape));
    }
    state.robot.check();
  } catch (const std::invalid_argument& error) {
    return bus::Rejection{bus::RejectReason::kBadValue, error.what()};
  }
  return state;
}

RobotShapes RobotState::in_camera_frame(const Placement& placement,
                                        const std::string& cloud_frame) const {
  if (robot.shapes.empty()) return {};
  return moved(robot, pose_of_camera(frame, placement, cloud_frame).inverse());
}

RobotShapes joined(RobotShapes a, const RobotShapes& b) {
  if (b.shapes.empty()) return a;
  if (a.shapes.empty()) return b;
  a.shapes.insert(a.shapes.end(), b.shapes.begin(), b.shapes.end());
  a.padding = std::max(a.padding, b.padding);
  return a;
}

}  // namespace quadrille
