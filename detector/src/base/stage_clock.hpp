#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Is told the name of each stage when it ends; a stage that is run again ends again. With several
/// threads it may be called by any of them, by one at a time.
using StageWatch = std::function<void(std::string_view stage)>;

/// Measures the wall time of consecutive stages.
class StageClock {
 public:
  explicit StageClock(StageWatch watch = {}) : watch_(std::move(watch)) {}

  /// Ends the current stage, which began at the end of the last one; times of equal names add up.
  void end(std::string_view stage) {
    const Clock::time_point now = Clock::now();
    const double ms = milliseconds(now - last_);
    last_ = now;
    const auto known = std::find_if(timings_.begin(), timings_.end(),
                                    [&](const StageTime& time) { return time.stage == stage; });
    if (known != timings_.end()) {
      known->ms += ms;
    } else {
      timings_.push_back({std::string(stage), ms});
    }
    if (watch_) watch_(stage);
  }

  /// Times of the stages in the order in which they first ended.
  const std::vector<StageTime>& timings() const { return timings_; }
  /// Time since the clock was made [ms].
  double total_ms() const { return milliseconds(Clock::now() - start_); }

 private:
  using Clock = std::chrono::steady_clock;

  static double milliseconds(Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
  }

  StageWatch watch_;
  std::vector<StageTime> timings_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace quadrille
