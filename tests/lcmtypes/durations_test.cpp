#include "run/durations.hpp"

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("durations give the nearest-rank percentiles of their window", "[bus][status]") {
  Durations durations(100);
  CHECK(durations.summary().max == 0.0);
  for (int i = 1; i <= 200; ++i) durations.add(i);
  CHECK(durations.summary().p50 == 150.0);
  CHECK(durations.summary().p90 == 190.0);
  CHECK(durations.summary().p99 == 199.0);
  CHECK(durations.summary().max == 200.0);
  // Those that have left the window count too.
  CHECK(durations.count() == 200);
  CHECK(durations.total() == 200 * 201 / 2);
  CHECK_THROWS_AS(Durations(0), std::invalid_argument);
}

}  // namespace
}  // namespace quadrille::bus
