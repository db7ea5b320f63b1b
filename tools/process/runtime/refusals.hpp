#pragma once

#include <chrono>
#include <string>

#include "quadrille/bus/rate_limiter.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille {

/// The messages of a channel that were refused: counted by reason, and logged at a bounded rate.
class Refusals {
 public:
  void add(const std::string& channel, const bus::Rejection& rejection);
  const bus::RejectCounts& counts() const { return counts_; }

 private:
  bus::RejectCounts counts_;
  bus::RateLimiter log_{std::chrono::seconds(1)};
};

/// "none refused", or "3 refused (cut_short 1, bad_length 2)".
std::string describe(const bus::RejectCounts& counts);

}  // namespace quadrille
