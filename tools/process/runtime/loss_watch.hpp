#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/rate_limiter.hpp"

namespace quadrille {

/// Tells of messages that are lost on their way into the process: at once, then at a bounded rate,
/// and at the end; and, more rarely, of datagrams that its filter refuses.
class LossWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// @return a record for the log, if there is something new to tell
  std::optional<std::string> check(const bus::Traffic& traffic,
                                   Clock::time_point now = Clock::now());

  /// What is wrong with the transport, one line each with the commands that mend it: judged by the
  /// messages that came, and as it looked at the start before any came.
  static std::vector<std::string> find_warnings(const bus::Traffic& traffic,
                                                const std::vector<std::string>& at_start);

  /// All that was lost or refused, with the commands that mend it; empty if nothing was.
  static std::string describe(const bus::Traffic& traffic);

 private:
  bus::RateLimiter log_{std::chrono::seconds(10)};
  bus::RateLimiter filter_log_{std::chrono::minutes(10)};
  bus::Traffic told_;
};

}  // namespace quadrille
