#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "process/runtime/node.hpp"

namespace quadrille {

/// The channels on which something should come, and nothing has come yet.
class SilentChannels {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// For so long nobody wonders.
  static constexpr std::chrono::seconds kGrace{10};

  SilentChannels(const std::vector<InChannel>& channels, TimePoint start);

  /// Something has come on the channel of that place. For any thread.
  void hear(std::size_t channel) { watched_[channel].heard = true; }

  /// A line for each channel that has been silent for too long; each is told once.
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
