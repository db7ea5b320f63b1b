#include "process/runtime/robot/robot_history.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "poses/cloud_frame.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
void RobotHistory::receive(const std::string& channel, std::span<const std::byte> bytes,
                           Refusals* refusals) {
  if (const auto refused = told_.add(bytes)) refusals->add(channel, *refused);
}

/// Returns the shapes in a frame D, in which `X_DF` places the frames that messages name.
RobotShapes RobotHistory::all_at(
    std::int64_t utime,
    const std::function<Eigen::Isometry3d(const std::string& frame)>& X_DF) const {
  const auto in_D = [&](const RobotState& state) {
    return state.robot.shapes.empty() ? RobotShapes{} : moved(state.robot, X_DF(state.frame));
  };
  const auto state = told_.at(utime);
  return state == nullptr ? in_D(given_) : joined(in_D(given_), in_D(*state));
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
  if (const auto state = told_.at(utime)) {
    all.insert(all.end(), state->attached.begin(), state->attached.end());
  }
  return all;
}

}  // namespace quadrille
