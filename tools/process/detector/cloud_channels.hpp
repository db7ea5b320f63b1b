#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "process/detector/settings.hpp"
#include "process/runtime/node.hpp"
#include "quadrille/bus/channel_pattern.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille {

/// The channels that clouds come on, one or those that a pattern matches, and those that their
/// results go to.
class CloudChannels {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// @param settings  must outlive this
  explicit CloudChannels(const DetectorSettings& settings);

  /// The channels that the process publishes on.
  std::vector<OutChannel> out_channels() const;

  /// True for a channel of clouds. A pattern may match the channels of the results too: these are
  /// none.
  bool matches(const std::string& channel) const;

  /// Takes note of a cloud. There is room for some channels, and one that has been silent makes
  /// room for another.
  /// @return why clouds of that channel are not taken; nullopt if they are
  std::optional<bus::Rejection> refuse(const std::string& channel, TimePoint now);

  /// Where the results of a channel's clouds go.
  /// @param name  of the results' channel, or what it begins with
  std::string results_channel(const std::string& name, const std::string& cloud_channel) const;

 private:
  bool forget_silent(TimePoint now);

  const DetectorSettings& settings_;
  const bus::ChannelPattern in_;
  /// On which clouds have come, with the time of the last one.
  std::map<std::string, TimePoint> known_;
};

}  // namespace quadrille
