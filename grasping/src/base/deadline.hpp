#pragma once

#include <chrono>
#include <optional>

namespace quadrille {

/// The wall-clock time by which work has to end.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;

  /// Makes a deadline that never passes.
  Deadline() = default;
  /// Makes a deadline that passes after so many milliseconds from now; 0 means never.
  explicit Deadline(double ms) {
    if (ms <= 0.0) return;
    const std::chrono::duration<double, std::milli> wait(ms);
    at_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(wait);
  }

  /// Returns false if it never passes.
  bool is_set() const { return at_.has_value(); }
  bool passed() const { return at_ && Clock::now() >= *at_; }

 private:
  std::optional<Clock::time_point> at_;
};

}  // namespace quadrille
