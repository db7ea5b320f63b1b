#include "process/runtime/robot/robot_history.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "poses/pose_history.hpp"
#include "process/runtime/poses/named_frame.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

// Clouds are handled before a robot that tells its shapes a hundred times a second has sent so many
// messages.
constexpr std::size_t kMaxStates = 256;

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
    // What is always so needs no history, and a clock that was set back ends it.
    const bool begins =
        state.utime == 0 ||
        (!states_.empty() && (states_.back().utime == 0 || state.utime < states_.back().utime));
    if (begins) states_.clear();
    states_.push_back(std::move(state));
    if (states_.size() > kMaxStates) states_.pop_front();
  } catch (const std::invalid_argument& error) {
    refusals->add(channel, {bus::RejectReason::kBadValue, error.what()});
  }
}

const RobotState* RobotHistory::nearest(std::int64_t utime) const {
  // A cloud that does not tell its time is likely new.
  if (utime == 0) return states_.empty() ? nullptr : &states_.back();
  const auto found =
      std::min_element(states_.begin(), states_.end(), [&](const auto& a, const auto& b) {
        return std::abs(seconds_between(a.utime, utime)) <
               std::abs(seconds_between(b.utime, utime));
      });
  return found == states_.end() ? nullptr : &*found;
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
  if (const RobotState* state = nearest(utime)) add(*state);
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
    if (frame == word_of(CloudFrame::kWorld))
      return Eigen::Isometry3d(Eigen::Isometry3d::Identity());
    throw std::invalid_argument("the robot's shapes are in frame '" + printable(frame) +
                                "'; for clouds of further cameras give them in 'world'");
  });
}

std::vector<SolidShape> RobotHistory::attached_at(std::int64_t utime) const {
  std::vector<SolidShape> all = given_.attached;
  if (const RobotState* state = nearest(utime)) {
    all.insert(all.end(), state->attached.begin(), state->attached.end());
  }
  return all;
}

}  // namespace quadrille
