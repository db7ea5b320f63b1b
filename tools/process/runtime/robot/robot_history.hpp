#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "poses/placement.hpp"
#include "poses/robot_state.hpp"
#include "poses/robot_trail.hpp"
#include "process/runtime/refusals.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille {

/// The shapes of a robot that moves. Not for two threads at once.
class RobotHistory {
 public:
  /// @param given  the shapes of the command line, which are there besides those of messages
  explicit RobotHistory(RobotState given) : given_(std::move(given)) {}

  /// Takes a message of type quadrille.robot_t; one that is refused is counted and logged.
  void receive(const std::string& channel, std::span<const std::byte> bytes, Refusals* refusals);

  /// Returns the robot's shapes in frame K of a cloud, those of the message that is nearest in
  /// time.
  /// @param utime  when the cloud was taken [us]
  /// @param cloud_frame  name of the cloud's frame
  /// @throws std::invalid_argument if the frame of the shapes is not known
  RobotShapes at(std::int64_t utime, const Placement& placement,
                 const std::string& cloud_frame) const;
  /// Returns the robot's shapes in the fixed frame W.
  /// @param utime  when they were there [us]
  /// @throws std::invalid_argument if they are given in another frame
  RobotShapes in_world(std::int64_t utime) const;
  /// Returns the robot's shapes in frame K of a further camera, whose clouds name no frame in which
  /// they could be placed but W. If they are given in another one that is counted and logged as a
  /// refusal of the channel, and the result is nullopt.
  std::optional<RobotShapes> at_view(std::int64_t utime, const Eigen::Isometry3d& X_WK,
                                     const std::string& channel, Refusals* refusals) const;
  /// Returns what was fixed to the hand then.
  std::vector<SolidShape> attached_at(std::int64_t utime) const;

 private:
  RobotShapes all_at(std::int64_t utime,
                     const std::function<Eigen::Isometry3d(const std::string& frame)>& X_DF) const;

  RobotState given_;
  RobotTrail told_;
};

}  // namespace quadrille
