#include "run/durations.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace quadrille::bus {
namespace {

double percentile(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

}  // namespace

Durations::Durations(std::size_t window) : window_(window) {
  if (window == 0) throw std::invalid_argument("window = 0: must be at least 1");
}

void Durations::add(double ms) {
  ++count_;
  total_ += ms;
  if (ms_.size() < window_) {
    ms_.push_back(ms);
  } else {
    ms_[next_] = ms;
  }
  next_ = (next_ + 1) % window_;
}

DurationSummary Durations::summary() const {
  if (ms_.empty()) return {};
  std::vector<double> sorted = ms_;
  std::sort(sorted.begin(), sorted.end());
  return {percentile(sorted, 0.5), percentile(sorted, 0.9), percentile(sorted, 0.99),
          sorted.back()};
}

}  // namespace quadrille::bus
