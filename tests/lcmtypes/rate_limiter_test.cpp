#include "run/rate_limiter.hpp"

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

using std::chrono::milliseconds;

TEST_CASE("one record in an interval is let through and the others are counted", "[bus][status]") {
  RateLimiter limiter(milliseconds(1000));
  const RateLimiter::Clock::time_point start;
  CHECK(limiter.admit(start) == 0);
  CHECK(limiter.admit(start + milliseconds(1)) == std::nullopt);
  CHECK(limiter.admit(start + milliseconds(999)) == std::nullopt);
  CHECK(limiter.admit(start + milliseconds(1000)) == 2);
  CHECK(limiter.admit(start + milliseconds(2000)) == 0);
}

}  // namespace
}  // namespace quadrille::bus
