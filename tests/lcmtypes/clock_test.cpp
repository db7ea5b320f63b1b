#include "run/clock.hpp"

#include <ctime>
#include <thread>

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("the wall clock tells microseconds since 1970", "[bus][clock]") {
  const std::int64_t before = std::time(nullptr);
  const std::int64_t now = wall_clock_utime();
  // time() reads a clock that ticks with the kernel's timer and lags behind by up to a tick.
  const std::int64_t after = std::time(nullptr) + 1;
  CHECK(now / 1000000 >= before);
  CHECK(now / 1000000 <= after);
}

TEST_CASE("durations are told in milliseconds", "[bus][clock]") {
  const auto start = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(ms_since(start) >= 20.0);
  CHECK(ms_since(start) < 20000.0);
}

}  // namespace
}  // namespace quadrille::bus
