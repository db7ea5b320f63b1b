#include "quadrille/bus/durations.hpp"
#include "quadrille/bus/network.hpp"
#include "quadrille/bus/rate_limiter.hpp"
#include "quadrille/bus/status_message.hpp"
#include "quadrille/bus/ticker.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

using std::chrono::milliseconds;

TEST_CASE("durations give the nearest-rank percentiles of their window", "[bus][status]") {
  Durations durations(100);
  CHECK(durations.summary().max == 0.0);
  for (int i = 1; i <= 200; ++i) durations.add(i);
  CHECK(durations.summary().p50 == 150.0);
  CHECK(durations.summary().p95 == 195.0);
  CHECK(durations.summary().max == 200.0);
  CHECK_THROWS_AS(Durations(0), std::invalid_argument);
}

TEST_CASE("one record in an interval is let through and the others are counted", "[bus][status]") {
  RateLimiter limiter(milliseconds(1000));
  const RateLimiter::Clock::time_point start;
  CHECK(limiter.admit(start) == 0);
  CHECK(limiter.admit(start + milliseconds(1)) == std::nullopt);
  CHECK(limiter.admit(start + milliseconds(999)) == std::nullopt);
  CHECK(limiter.admit(start + milliseconds(1000)) == 2);
  CHECK(limiter.admit(start + milliseconds(2000)) == 0);
}

TEST_CASE("a ticker is due once in a period", "[bus][status]") {
  const Ticker::Clock::time_point start;
  Ticker ticker(milliseconds(1000), start);
  CHECK_FALSE(ticker.due(start + milliseconds(999)));
  CHECK(ticker.due(start + milliseconds(5000)));
  CHECK_FALSE(ticker.due(start + milliseconds(5500)));
  CHECK(ticker.due(start + milliseconds(6000)));
}

TEST_CASE("only reasons that occurred go into the status", "[bus][status]") {
  RejectCounts counts;
  CHECK(to_message(counts).empty());
  counts.add(RejectReason::kCutShort);
  counts.add(RejectReason::kCutShort);
  const auto message = to_message(counts);
  REQUIRE(message.size() == 1);
  CHECK(message[0].name == "cut_short");
  CHECK(message[0].count == 2);
}

TEST_CASE("a receive buffer too small is told with the command that mends it", "[bus][network]") {
  CHECK(find_buffer_problem(32 << 20, 4 << 20) == std::nullopt);
  const auto capped = find_buffer_problem(32 << 20, 212992);
  REQUIRE(capped);
  CHECK(capped->find("sudo sysctl -w net.core.rmem_max=33554432") != std::string::npos);
  const auto asked_too_little = find_buffer_problem(100000, 100000);
  REQUIRE(asked_too_little);
  CHECK(asked_too_little->find("recv_buf_size=33554432 in the LCM address") != std::string::npos);
}

TEST_CASE("the kernel grants what a small buffer asks for", "[bus][network]") {
  CHECK(granted_receive_buffer(65536) == 65536);
}

}  // namespace
}  // namespace quadrille::bus
