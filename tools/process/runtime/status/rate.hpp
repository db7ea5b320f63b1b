#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <utility>

namespace quadrille {

/// Measures how fast a count grows.
class Rate {
 public:
  using Clock = std::chrono::steady_clock;

  /// Returns the mean rate over the last ten seconds, or since the first call [1/s]; 0 at the first
  /// call.
  double update(std::int64_t count, Clock::time_point now = Clock::now()) {
    constexpr std::chrono::seconds kWindow(10);
    counts_.emplace_back(now, count);
    while (counts_.size() > 2 && now - counts_[1].first >= kWindow) counts_.pop_front();
    const auto& [start, first] = counts_.front();
    const double seconds = std::chrono::duration<double>(now - start).count();
    return seconds > 0.0 ? static_cast<double>(count - first) / seconds : 0.0;
  }

 private:
  std::deque<std::pair<Clock::time_point, std::int64_t>> counts_;
};

}  // namespace quadrille
