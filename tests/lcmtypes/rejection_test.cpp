#include "quadrille/bus/rejection.hpp"

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("refusals are counted by reason", "[bus][status]") {
  RejectCounts counts;
  CHECK(counts.total() == 0);
  counts.add(RejectReason::kTooLarge);
  counts.add(RejectReason::kInternal);
  counts.add(RejectReason::kInternal);
  CHECK(counts.of(RejectReason::kTooLarge) == 1);
  CHECK(counts.of(RejectReason::kInternal) == 2);
  CHECK(counts.of(RejectReason::kBadValue) == 0);
  CHECK(counts.total() == 3);
}

}  // namespace
}  // namespace quadrille::bus
