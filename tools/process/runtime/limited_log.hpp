#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "run/rate_limiter.hpp"

namespace quadrille {

/// Logs at most one record per interval, with the number of those left out before it. For any
/// thread.
class LimitedLog {
 public:
  using Clock = bus::RateLimiter::Clock;

  explicit LimitedLog(std::chrono::milliseconds interval = std::chrono::seconds(1))
      : limiter_(interval) {}

  void warning(const std::string& record, Clock::time_point now = Clock::now());
  void error(const std::string& record, Clock::time_point now = Clock::now());

 private:
  void log(void (*write)(const std::string&), const std::string& record, Clock::time_point now);

  std::mutex mutex_;
  bus::RateLimiter limiter_;
};

}  // namespace quadrille
