#include "process/runtime/robot/robot_history.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "process/runtime/poses/named_frame.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

/// @throws std::invalid_argument if a shape is no solid
RobotState state_of(const robot_t& message) {
  RobotState state{message.utime, message.frame, {{}, message.padding}, {}};
  for (const collision_shape_t& shape : message.shapes) {
    state.robot.shapes.push_back(bus::from_message(shape));
  }
  for (const collision_shape_t& shape : message.attached) {
    state.attached.push_back(bus::from_message(shape));
  }
  state.robot.check();
  return state;
}

}  // namespace

void RobotHistory::receive(const std::string& channel, std::span<const std::byte> bytes,
                           Refusals* refusals) {
  const auto message = refusals->accept(channel, bus::decode_robot(bytes));
  if (!message) return;
  try {
    RobotState state = state_of(*message);
    states_.add(message->utime, bytes.size(), std::move(state));
  } catch (const std::invalid_argument& error) {
    refusals->add(channel, {bus::RejectReason::kBadValue, error.what()});
  }
}

/// Returns the shapes in a frame D, in which `X_DF` places the frames that messages name.
RobotShapes RobotHistory::all_at(
    std::int64_t utime,
    const std::function<Eigen::Isometry3d(const std::string& frame)>& X_DF) const {
  RobotShapes all;
  all.padding = 0.0;
  const auto add = [&](const RobotState& state) {
    if (state.robot.shapes.empty()) return;
    const RobotShapes robot_D = moved(state.robot, X_DF(state.frame));
    all.shapes.insert(all.shapes.end(), robot_D.shapes.begin(), robot_D.shapes.end());
    all.padding = std::max(all.padding, robot_D.padding);
  };
  add(given_);
  if (const RobotState* state = states_.nearest(utime)) add(*state);
  return all;
}

RobotShapes RobotHistory::at(std::int64_t utime, const Placement& placement,
                             const std::string& cloud_frame) const {
  return all_at(utime, [&](const std::string& frame) {
    return pose_of_camera(frame, placement, cloud_frame).inverse();
  });
}

RobotShapes RobotHistory::in_world(std::int64_t utime) const {
  return all_at(utime, [](const std::string& frame) {
    if (frame == to_string(CloudFrame::kWorld))
      return Eigen::Isometry3d(Eigen::Isometry3d::Identity());
    throw std::invalid_argument("the robot's shapes are in frame '" + printable(frame) +
                                "'; for clouds of further cameras give them in 'world'");
  });
}

std::optional<RobotShapes> RobotHistory::at_view(std::int64_t utime, const Eigen::Isometry3d& X_WK,
                                                 const std::string& channel,
                                                 Refusals* refusals) const {
  try {
    return moved(in_world(utime), X_WK.inverse());
  } catch (const std::invalid_argument& error) {
    refusals->add(channel, {bus::RejectReason::kBadValue, error.what()});
    return std::nullopt;
  }
}

std::vector<SolidShape> RobotHistory::attached_at(std::int64_t utime) const {
  std::vector<SolidShape> all = given_.attached;
  if (const RobotState* state = states_.nearest(utime)) {
    all.insert(all.end(), state->attached.begin(), state->attached.end());
  }
  return all;
}

}  // namespace quadrille
