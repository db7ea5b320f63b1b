#include "quadrille/bus/status_message.hpp"

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

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

}  // namespace
}  // namespace quadrille::bus
