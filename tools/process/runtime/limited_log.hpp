#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

#include "quadrille/bus/rate_limiter.hpp"

namespace quadrille {

/// A record, and how many like it were left out before it.
std::string with_held_back(const std::string& record, std::int64_t held_back);

/// Logs a record a second at most, and with it how many it left out before. For any thread.
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
