#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "link/connection.hpp"
#include "run/rate_limiter.hpp"

namespace quadrille {

/// Reports messages that are lost on their way into the process: at once, then at a limited rate,
/// and at the end. Reports more rarely on datagrams that the process's filter refuses.
class LossWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// @return a record for the log, if there is anything new
  std::optional<std::string> check(const bus::Traffic& traffic,
                                   Clock::time_point now = Clock::now());

  /// Returns what is wrong with the transport, one line each with the remedy, judged by the
  /// messages that came; before any came, returns the warnings from the start.
  static std::vector<std::string> find_warnings(const bus::Traffic& traffic,
                                                const std::vector<std::string>& at_start);

  /// Describes everything that was lost or refused, with the remedies; empty if nothing was.
  static std::string describe(const bus::Traffic& traffic);

 private:
  bus::RateLimiter log_{std::chrono::seconds(10)};
  bus::RateLimiter filter_log_{std::chrono::minutes(10)};
  bus::Traffic told_;
};

}  // namespace quadrille
