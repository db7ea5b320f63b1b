#include "run/rate_limiter.hpp"

#include <utility>

namespace quadrille::bus {

std::optional<std::int64_t> RateLimiter::admit(Clock::time_point now) {
  if (last_ && now - *last_ < interval_) {
    ++held_back_;
    return std::nullopt;
  }
  last_ = now;
  return std::exchange(held_back_, 0);
}

}  // namespace quadrille::bus
