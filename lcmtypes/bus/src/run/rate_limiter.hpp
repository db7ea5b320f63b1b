#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace quadrille::bus {

/// Lets at most one record per interval through, and counts those it holds back.
class RateLimiter {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param interval  the shortest time between two records that are let through
  explicit RateLimiter(std::chrono::milliseconds interval) : interval_(interval) {}

  /// Asks to let one record through at the given time.
  /// @return number of records held back since the last one let through; nullopt to hold this one
  ///   back too
  std::optional<std::int64_t> admit(Clock::time_point now = Clock::now());

 private:
  std::chrono::milliseconds interval_;
  std::optional<Clock::time_point> last_;
  std::int64_t held_back_ = 0;
};

}  // namespace quadrille::bus
