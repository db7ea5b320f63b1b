#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "log/event_log.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille::logs {

/// One cloud of a log.
struct LoggedCloud {
  bus::CloudMessage message;
  std::string channel;
  /// Time at which the event was logged [us].
  std::int64_t event_utime = 0;
};

/// Reads the clouds of an LCM log in order, in all formats.
class CloudLogReader {
 public:
  /// Called for each event of the log, before a cloud is made of it.
  using OnEvent = std::function<void(const bus::LogReader::Event&)>;

  /// @param channel  the only channel to read; if empty, all channels are read, and events of other
  ///   types are skipped
  /// @param unit  length of the unit of the clouds' coordinates [m]
  /// @throws std::runtime_error as bus::LogReader does
  explicit CloudLogReader(const std::string& path, const std::string& channel = "",
                          double unit = 1.0, OnEvent on_event = nullptr);

  /// Returns the next cloud; nullopt at the end. Events that are not valid clouds are counted.
  std::optional<LoggedCloud> next();

  /// Number of events refused so far, by reason.
  const bus::RejectCounts& rejected() const { return rejected_; }
  /// Number of events read so far by channel, including the skipped ones.
  const std::map<std::string, std::int64_t>& channels() const { return channels_; }
  /// Share of the log that has been read, from 0 to 1.
  double share() const;
  /// Describes where the log is truncated or damaged; nullopt if it is complete.
  const std::optional<std::string>& defect() const { return log_.survey().defect; }

 private:
  bus::LogReader log_;
  std::string channel_;
  double unit_;
  OnEvent on_event_;
  std::int64_t read_ = 0;
  bus::RejectCounts rejected_;
  std::map<std::string, std::int64_t> channels_;
};

}  // namespace quadrille::logs
