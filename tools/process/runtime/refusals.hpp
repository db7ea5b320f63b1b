#pragma once

#include <chrono>
#include <string>

#include "quadrille/bus/rejection.hpp"
#include "run/rate_limiter.hpp"

namespace quadrille {

/// Counts the refused messages of a channel by reason, and logs them at a limited rate.
class Refusals {
 public:
  void add(const std::string& channel, const bus::Rejection& rejection);
  const bus::RejectCounts& counts() const { return counts_; }

 private:
  bus::RejectCounts counts_;
  bus::RateLimiter log_{std::chrono::seconds(1)};
};

/// Returns "none refused", or "3 refused (cut_short 1, bad_length 2)".
std::string describe(const bus::RejectCounts& counts);

}  // namespace quadrille
