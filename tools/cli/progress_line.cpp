#include "cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace quadrille {

ProgressLine::~ProgressLine() {
  if (shown_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double share) {
  // Work that is over sooner needs no forecast, and the first steps allow none [s].
  constexpr double kMinTime = 5.0;
  const int percent = static_cast<int>(100.0 * share);
  const Clock::time_point now = Clock::now();
  const bool is_news = percent != shown_ || now - last_ > std::chrono::seconds(1);
  if (!is_news || !isatty(STDERR_FILENO)) return;
  shown_ = percent;
  last_ = now;
  const int filled = percent / 4;
  std::string line = fmt::format("\r[{:=>{}}{:>{}}] {:3} %", "", filled, "", 25 - filled, percent);
  const double passed = std::chrono::duration<double>(now - start_).count();
  if (passed > kMinTime && share > 0.0) {
    line += fmt::format(", {} left", describe_duration(passed * (1.0 - share) / share));
  }
  std::fputs((line + "\033[K").c_str(), stderr);
}

std::string describe_duration(double seconds) {
  const long whole = std::lround(std::ceil(seconds)), minutes = (whole + 30) / 60;
  if (whole < 100) return fmt::format("{} s", whole);
  if (minutes < 100) return fmt::format("{} min", minutes);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace quadrille
