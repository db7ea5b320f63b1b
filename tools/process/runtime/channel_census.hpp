#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "process/runtime/node.hpp"

namespace quadrille {

/// Counts the events of a log by channel, to tell a channel that is named wrong from an empty one.
class ChannelCensus {
 public:
  void add(const std::string& channel) { ++events_[channel]; }

  /// A line for each of the channels that had no event, with those that had some.
  /// @param prefix  of --channel-prefix, with which the wanted ones begin
  std::vector<std::string> find_missing(const std::vector<InChannel>& wanted,
                                        const std::string& prefix = "") const;

  /// Those of the channels that had events, with the options that rename them; empty if none had.
  std::string find_taken(const std::vector<OutChannel>& wanted) const;

 private:
  std::string advise(const std::string& option, const std::string& prefix) const;

  std::map<std::string, std::int64_t> events_;
};

}  // namespace quadrille
