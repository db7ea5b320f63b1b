#include "quadrille/bus/ticker.hpp"

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

using std::chrono::milliseconds;

TEST_CASE("a ticker is due once in a period", "[bus][status]") {
  const Ticker::Clock::time_point start;
  Ticker ticker(milliseconds(1000), start);
  CHECK_FALSE(ticker.due(start + milliseconds(999)));
  CHECK(ticker.due(start + milliseconds(5000)));
  CHECK_FALSE(ticker.due(start + milliseconds(5500)));
  CHECK(ticker.due(start + milliseconds(6000)));
}

}  // namespace
}  // namespace quadrille::bus
