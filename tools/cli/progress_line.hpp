#pragma once

#include <chrono>
#include <string>

namespace quadrille {

/// Shows on the standard error the progress of work and the time that it may still take. On a
/// terminal this is one line, which is wiped on destruction; elsewhere it is a line every ten
/// seconds.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// @param share  share of the work that is done, 0 to 1
  void show(double share);
  /// Clears the line for other output until the next show().
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;

  std::string time_left(double share, Clock::time_point now) const;

  bool on_terminal_;
  int shown_ = -1;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// Formats a duration: "45 s", "12 min", "3 h 05 min".
std::string describe_duration(double seconds);

}  // namespace quadrille
