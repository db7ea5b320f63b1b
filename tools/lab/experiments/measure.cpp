#include "lab/experiments/measure.hpp"

#include <time.h>

#include <algorithm>
#include <stdexcept>

namespace quadrille::experiments {
namespace {

double thread_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double microseconds(const std::function<void()>& call) {
  const double start = thread_time();
  call();
  return thread_time() - start;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) throw std::invalid_argument("no values to take a quantile of");
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace quadrille::experiments
