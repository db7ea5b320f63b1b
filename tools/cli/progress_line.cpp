#include "cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace quadrille {

ProgressLine::ProgressLine() : on_terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() { wipe(); }

void ProgressLine::wipe() {
  if (on_terminal_ && shown_ >= 0) std::fputs("\r\033[K", stderr);
  shown_ = -1;
}

void ProgressLine::show(double share) {
  const int percent = static_cast<int>(100.0 * share);
  const Clock::time_point now = Clock::now();
  // Without a terminal nothing can be wiped, so the lines are those of a log.
  const std::chrono::seconds period(on_terminal_ ? 1 : 10);
  const bool is_news = on_terminal_ && percent != shown_;
  if (!is_news && now - last_ < period) return;
  shown_ = percent;
  last_ = now;
  const std::string left = time_left(share, now);
  if (!on_terminal_) {
    fmt::print(stderr, "quadrille: {} % done{}\n", percent, left);
    return;
  }
  const int filled = percent / 4;
  fmt::print(stderr, "\r[{:=>{}}{:>{}}] {:3} %{}\033[K", "", filled, "", 25 - filled, percent,
             left);
}

std::string ProgressLine::time_left(double share, Clock::time_point now) const {
  // Shorter work needs no forecast, and the first steps do not allow one [s].
  constexpr double kMinTime = 5.0;
  const double passed = std::chrono::duration<double>(now - start_).count();
  if (passed < kMinTime || share <= 0.0) return "";
  return fmt::format(", {} left", describe_duration(passed * (1.0 - share) / share));
}

std::string describe_duration(double seconds) {
  const long whole = std::lround(std::ceil(seconds)), minutes = (whole + 30) / 60;
  if (whole < 100) return fmt::format("{} s", whole);
  if (minutes < 100) return fmt::format("{} min", minutes);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace quadrille
