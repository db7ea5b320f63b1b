#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/event_log.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille::logs {

/// One cloud of a log.
struct LoggedCloud {
  bus::CloudMessage message;
  std::string channel;
  /// When the event was logged [us].
  std::int64_t event_utime = 0;
};

/// Reads the clouds of an LCM log in order, of all the formats.
class CloudLogReader {
 public:
  /// @param channel  only this channel; empty: all channels, whose events of other types are passed
  ///   over
  /// @throws std::runtime_error as bus::survey_log() does
  explicit CloudLogReader(const std::string& path, const std::string& channel = "");

  /// The next cloud; nullopt at the end. Events that are no valid clouds are counted.
  std::optional<LoggedCloud> next();

  /// Events refused so far, by reason.
  const bus::RejectCounts& rejected() const { return rejected_; }
  /// The events read so far of each channel, of those passed over too.
  const std::map<std::string, std::int64_t>& channels() const { return channels_; }
  /// How much of the log has been read, from 0 to 1.
  double share() const;
  /// Where the log is cut short or damaged; nullopt if it is whole.
  const std::optional<std::string>& defect() const { return log_.survey().defect; }

 private:
  bus::LogReader log_;
  std::string channel_;
  std::int64_t read_ = 0;
  bus::RejectCounts rejected_;
  std::map<std::string, std::int64_t> channels_;
};

}  // namespace quadrille::logs
