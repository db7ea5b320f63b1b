#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logs/cloud_log_reader.hpp"

namespace quadrille::view {

/// Gives access to the clouds of an LCM log in any order. Going forward is fast; going back reads
/// the log from its start.
class LogFrames {
 public:
  /// Reads the whole log once to find its clouds.
  /// @param unit  length of the unit of the clouds' coordinates [m]
  /// @throws std::runtime_error as logs::CloudLogReader does, and if there is no cloud
  LogFrames(const std::string& path, const std::string& channel, double unit = 1.0);

  /// Time at which each cloud was taken [us].
  const std::vector<std::int64_t>& utimes() const { return utimes_; }
  const std::string& path() const { return path_; }
  /// Describes where the log is truncated; nullopt if it is complete.
  const std::optional<std::string>& defect() const { return defect_; }

  /// Returns the cloud with this number, counted from 0; nullopt if there is none.
  std::optional<logs::LoggedCloud> load(std::size_t number);

 private:
  std::string path_, channel_;
  double unit_;
  std::optional<std::string> defect_;
  std::vector<std::int64_t> utimes_;
  /// Position of each cloud among all events of the log.
  std::vector<std::int64_t> events_;
  std::unique_ptr<bus::LogReader> reader_;
  std::int64_t next_event_ = 0;
};

}  // namespace quadrille::view
