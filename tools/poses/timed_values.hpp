#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include "poses/pose_history.hpp"

namespace quadrille {

/// The last values of something that changes, each with its time, such as the shapes of a robot
/// that moves.
template <class Value>
class TimedValues {
 public:
  /// @param most  number of values to keep, at least 1
  /// @param max_bytes  memory of the values to keep; the newest is always kept
  TimedValues(std::size_t most, std::size_t max_bytes) : most_(most), max_bytes_(max_bytes) {}

  /// Adds a value.
  /// @param utime  when it was so [us]; 0: always
  void add(std::int64_t utime, std::size_t bytes, Value value) {
    // What is always so needs no history, and a clock that was set back ends it.
    const bool begins =
        utime == 0 || (!kept_.empty() && (kept_.back().utime == 0 || utime < kept_.back().utime));
    if (begins) {
      kept_.clear();
      bytes_ = 0;
    }
    kept_.push_back({utime, bytes, std::move(value)});
    bytes_ += bytes;
    while (kept_.size() > most_ || (kept_.size() > 1 && bytes_ > max_bytes_)) {
      bytes_ -= kept_.front().bytes;
      kept_.pop_front();
    }
  }

  /// Returns the value that is nearest to a time [us], or the newest one for a time of 0, since
  /// what does not tell its time is likely new; null if there is none.
  const Value* nearest(std::int64_t utime) const {
    if (kept_.empty()) return nullptr;
    if (utime == 0) return &kept_.back().value;
    const auto distance = [&](const Kept& k) { return std::abs(seconds_between(k.utime, utime)); };
    return &std::min_element(kept_.begin(), kept_.end(), [&](const Kept& a, const Kept& b) {
              return distance(a) < distance(b);
            })->value;
  }

 private:
  struct Kept {
    std::int64_t utime = 0;
    std::size_t bytes = 0;
    Value value;
  };

  std::size_t most_, max_bytes_, bytes_ = 0;
  std::deque<Kept> kept_;
};

}  // namespace quadrille
