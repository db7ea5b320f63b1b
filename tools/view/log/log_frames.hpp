#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logs/cloud_log_reader.hpp"
#include "logs/robot_refusals.hpp"
#include "poses/robot_trail.hpp"

namespace quadrille::view {

/// One cloud of a log, with what the robot said of itself.
struct LogFrame {
  /// Number of the cloud, counted from 0.
  std::size_t number = 0;
  logs::LoggedCloud cloud;
  /// The robot's own shapes that were told nearest in time; null if none had been.
  std::shared_ptr<const RobotState> robot;
};

/// Gives access to the clouds of an LCM log in any order. Going forward is fast; going back reads
/// the log from its start.
class LogFrames {
 public:
  /// Reads the whole log once to find its clouds.
  /// @param unit  length of the unit of the clouds' coordinates [m]
  /// @param robot_channel  channel of the robot's own shapes (quadrille.robot_t); empty for none
  /// @throws std::runtime_error as logs::CloudLogReader does, and if there is no cloud
  LogFrames(const std::string& path, const std::string& channel, double unit = 1.0,
            const std::string& robot_channel = "");

  /// Time at which each cloud was taken [us].
  const std::vector<std::int64_t>& utimes() const { return utimes_; }
  const std::string& path() const { return path_; }
  /// Messages on the robot of the whole log that were refused.
  const logs::RobotRefusals& robot_refusals() const { return robot_refusals_; }
  /// Describes where the log is truncated; nullopt if it is complete.
  const std::optional<std::string>& defect() const { return defect_; }

  /// Returns the cloud with this number, counted from 0; nullopt if there is none.
  std::optional<LogFrame> load(std::size_t number);

 private:
  std::string path_, channel_, robot_channel_;
  logs::RobotRefusals robot_refusals_;
  double unit_;
  std::optional<std::string> defect_;
  std::vector<std::int64_t> utimes_;
  /// Position of each cloud among all events of the log.
  std::vector<std::int64_t> events_;
  std::unique_ptr<bus::LogReader> reader_;
  std::int64_t next_event_ = 0;
  /// The robot's own shapes, of the messages before that event.
  RobotTrail robot_;
};

}  // namespace quadrille::view
