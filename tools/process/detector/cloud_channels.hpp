#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "link/channel_pattern.hpp"
#include "process/detector/settings.hpp"
#include "process/runtime/node.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille {

/// The channels on which clouds come, one or all that a pattern matches, and the channels for their
/// results.
class CloudChannels {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// @param settings  must outlive this object
  explicit CloudChannels(const DetectorSettings& settings);

  /// Returns the channels on which the process publishes.
  std::vector<OutChannel> out_channels() const;

  /// Returns true for a channel of clouds. A pattern may also match channels of results, which are
  /// excluded.
  bool matches(const std::string& channel) const;

  /// Notes that a cloud has come. The number of channels is limited, and a silent one makes room
  /// for another.
  /// @return why clouds of that channel are refused; nullopt if they are accepted
  std::optional<bus::Rejection> refuse(const std::string& channel, TimePoint now);

  /// Returns the channel for the results of a channel's clouds.
  /// @param name  name of the results' channel, or its beginning
  std::string results_channel(const std::string& name, const std::string& cloud_channel) const;

 private:
  bool forget_silent(TimePoint now);

  const DetectorSettings& settings_;
  const bus::ChannelPattern in_;
  /// Channels on which clouds have come, with the time of the last one.
  std::map<std::string, TimePoint> known_;
};

}  // namespace quadrille
