#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::bus {

/// Percentiles of durations [ms].
struct DurationSummary {
  double p50 = 0.0, p90 = 0.0, p99 = 0.0, max = 0.0;
};

/// The most recent durations of a repeated event.
class Durations {
 public:
  /// @param window  number of most recent durations that count, at least 1
  /// @throws std::invalid_argument if the window is 0
  explicit Durations(std::size_t window = 1000);

  /// @param ms  a further duration [ms]
  void add(double ms);

  /// Nearest-rank percentiles over the window; zeros before the first duration.
  DurationSummary summary() const;

  /// Number of durations since the start, and their sum [ms].
  std::int64_t count() const { return count_; }
  double total() const { return total_; }

 private:
  std::size_t window_, next_ = 0;
  std::vector<double> ms_;
  std::int64_t count_ = 0;
  double total_ = 0.0;
};

}  // namespace quadrille::bus
