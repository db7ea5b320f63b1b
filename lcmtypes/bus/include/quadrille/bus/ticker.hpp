#pragma once

#include <chrono>

namespace quadrille::bus {

/// Tells when a periodic task is due.
class Ticker {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param period  time between calls; the task is first due one period after the start
  explicit Ticker(std::chrono::milliseconds period, Clock::time_point start = Clock::now())
      : period_(period), last_(start) {}

  /// True once per period; missed periods are skipped.
  bool due(Clock::time_point now = Clock::now()) {
    if (now - last_ < period_) return false;
    last_ = now;
    return true;
  }

 private:
  std::chrono::milliseconds period_;
  Clock::time_point last_;
};

}  // namespace quadrille::bus
