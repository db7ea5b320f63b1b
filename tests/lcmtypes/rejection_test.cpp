#include "quadrille/bus/rejection.hpp"

#include <set>

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("each reason has a name of its own", "[bus][status]") {
  std::set<std::string_view> names;
  for (const RejectReason reason : all_reject_reasons()) names.insert(to_string(reason));
  CHECK(names.size() == kRejectReasonCount);
  CHECK(to_string(RejectReason::kTrailingBytes) == "trailing_bytes");
}

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
