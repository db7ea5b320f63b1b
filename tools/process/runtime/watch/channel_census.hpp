#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "process/runtime/node.hpp"

namespace quadrille {

/// Counts the events of a log by channel, to distinguish a wrong channel name from an empty log.
class ChannelCensus {
 public:
  void add(const std::string& channel) { ++events_[channel]; }

  /// Returns a line for each wanted channel without events, with the channels that have some.
  /// @param prefix  value of --channel-prefix, with which the wanted names begin
  std::vector<std::string> find_missing(const std::vector<InChannel>& wanted,
                                        const std::string& prefix = "") const;

  /// Returns the wanted channels that have events, with the options that rename them; empty if
  /// there are none.
  std::string find_taken(const std::vector<OutChannel>& wanted) const;

 private:
  std::string advise(const std::string& option, const std::string& prefix) const;

  std::map<std::string, std::int64_t> events_;
};

}  // namespace quadrille
