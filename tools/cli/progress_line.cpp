#include "cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace quadrille {

ProgressLine::~ProgressLine() {
  if (shown_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double share) {
  const int percent = static_cast<int>(100.0 * share);
  if (percent == shown_ || !isatty(STDERR_FILENO)) return;
  shown_ = percent;
  const int filled = percent / 4;
  std::fputs(fmt::format("\r[{:=>{}}{:>{}}] {:3} %", "", filled, "", 25 - filled, percent).c_str(),
             stderr);
}

}  // namespace quadrille
