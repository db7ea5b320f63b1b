#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "logs/cloud_log_reader.hpp"
#include "logs/robot_refusals.hpp"
#include "poses/camera_poses.hpp"
#include "poses/robot_trail.hpp"
#include "poses/waiting_clouds.hpp"

namespace quadrille::logs {

/// One cloud of a log, with the pose that its camera had, or why that is not known.
struct PosedCloud {
  LoggedCloud cloud;
  CameraPose pose;
  /// The robot's own shapes that were told nearest in time; null if none had been.
  std::shared_ptr<const RobotState> robot;
};

/// Reads the clouds of a moving camera, and its poses, from an LCM log. Each cloud gets the pose
/// that the processes give it when they replay the log: it waits for the pose after it for some
/// time by the clock of the log's events.
class PosedLogReader {
 public:
  /// @param channel  as CloudLogReader has it
  /// @param pose_channel  channel of the poses (bot_core.pose_t); if empty, no cloud has a pose,
  /// and
  ///   none waits
  /// @param max_age,  max_wait  as CameraPoses has them [s]
  /// @param unit  length of the unit of the clouds' coordinates [m]
  /// @param robot_channel  channel of the robot's own shapes (quadrille.robot_t); empty for none
  /// @throws std::runtime_error as bus::LogReader does
  PosedLogReader(const std::string& path, const std::string& channel, std::string pose_channel,
                 double max_age, double max_wait, double unit = 1.0,
                 std::string robot_channel = "");
  PosedLogReader(const PosedLogReader&) = delete;
  PosedLogReader& operator=(const PosedLogReader&) = delete;

  /// Returns the next cloud; nullopt at the end.
  std::optional<PosedCloud> next();

  /// The reader of the clouds, which knows what else the log holds.
  const CloudLogReader& clouds() const { return clouds_; }
  /// Messages on the robot that were refused so far, and why the first was.
  const RobotRefusals& robot_refusals() const { return robot_refusals_; }

 private:
  void take(const bus::LogReader::Event& event);
  void settle(bool is_end = false);

  std::string pose_channel_, robot_channel_;
  RobotTrail robot_;
  RobotRefusals robot_refusals_;
  /// Clouds whose poses are not known yet.
  WaitingClouds<LoggedCloud> waiting_;
  CloudLogReader clouds_;
  /// Time of the last event [us].
  std::int64_t now_ = 0;
  std::deque<PosedCloud> ready_;
};

}  // namespace quadrille::logs
