#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logs/cloud_log_reader.hpp"

namespace quadrille::view {

/// The clouds of an LCM log in any order. Going forward is fast; going back reads from the start.
class LogFrames {
 public:
  /// Reads all of the log once, to know its clouds.
  /// @throws std::runtime_error as logs::CloudLogReader does, and if there is no cloud
  LogFrames(const std::string& path, const std::string& channel);

  /// When each cloud was taken [us].
  const std::vector<std::int64_t>& utimes() const { return utimes_; }
  const std::string& path() const { return path_; }
  /// Where the log is cut short; nullopt if it is whole.
  const std::optional<std::string>& defect() const { return defect_; }

  /// The cloud of that number, counted from 0; nullopt if there is none.
  std::optional<logs::LoggedCloud> load(std::size_t number);

 private:
  std::string path_, channel_;
  std::optional<std::string> defect_;
  std::vector<std::int64_t> utimes_;
  /// Where each cloud stands among all events of the log.
  std::vector<std::int64_t> events_;
  std::unique_ptr<bus::LogReader> reader_;
  std::int64_t next_event_ = 0;
};

}  // namespace quadrille::view
