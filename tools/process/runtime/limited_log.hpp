#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

#include "run/rate_limiter.hpp"

namespace quadrille {

/// Returns a record with the number of similar ones that were left out before it.
std::string with_held_back(const std::string& record, std::int64_t held_back);

/// Logs at most one record per second, with the number of those left out before it. For any thread.
class LimitedLog {
 public:
  void warning(const std::string& record);
  void error(const std::string& record);

 private:
  void log(void (*write)(const std::string&), const std::string& record);

  std::mutex mutex_;
  bus::RateLimiter limiter_{std::chrono::seconds(1)};
};

}  // namespace quadrille
