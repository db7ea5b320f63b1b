#pragma once

#include <chrono>
#include <string>

namespace quadrille {

/// Tells on the standard error how far work is and how long it may still take: on a terminal as one
/// line, which is wiped when this goes, elsewhere as a line every ten seconds.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// @param share  of the work that is done, 0 to 1
  void show(double share);
  /// Makes room for other output until the next show().
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;

  std::string time_left(double share, Clock::time_point now) const;

  bool on_terminal_;
  int shown_ = -1;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// A duration for people: "45 s", "12 min", "3 h 05 min".
std::string describe_duration(double seconds);

}  // namespace quadrille
