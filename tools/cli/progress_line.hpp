#pragma once

#include <chrono>
#include <string>

namespace quadrille {

/// A line on a terminal that shows how far it is and how long it may still take; nothing elsewhere.
/// Wiped when it goes.
class ProgressLine {
 public:
  ProgressLine() = default;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// @param share  of the work that is done, 0 to 1
  void show(double share);

 private:
  using Clock = std::chrono::steady_clock;

  int shown_ = -1;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// A duration for people: "45 s", "12 min", "3 h 05 min".
std::string describe_duration(double seconds);

}  // namespace quadrille
