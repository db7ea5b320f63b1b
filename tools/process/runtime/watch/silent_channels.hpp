#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "process/runtime/node.hpp"

namespace quadrille {

/// The channels on which messages are expected but none has come yet.
class SilentChannels {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// Time of silence before a channel is reported.
  static constexpr std::chrono::seconds kGrace{10};

  SilentChannels(const std::vector<InChannel>& channels, TimePoint start);

  /// Notes that a message has come on the channel with this index. For any thread.
  void hear(std::size_t channel) { watched_[channel].heard = true; }

  /// Returns a line for each channel that has been silent for too long; each is reported once.
  std::vector<std::string> find_warnings(TimePoint now);

 private:
  struct Watched {
    InChannel channel;
    std::atomic<bool> heard{false};
    bool told = false;
  };

  TimePoint start_;
  std::deque<Watched> watched_;
};

}  // namespace quadrille
