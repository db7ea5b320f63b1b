#include "process/runtime/refusals.hpp"

#include "support/catch.hpp"

namespace quadrille {
namespace {

TEST_CASE("refusals are told by reason", "[process][hostile]") {
  Refusals refusals;
  CHECK(describe(refusals.counts()) == "none refused");
  refusals.add("A", {bus::RejectReason::kBadLength, "x"});
  refusals.add("A", {bus::RejectReason::kCutShort, "y"});
  refusals.add("A", {bus::RejectReason::kBadLength, "z"});
  CHECK(describe(refusals.counts()) == "3 refused (cut_short 1, bad_length 2)");
}

}  // namespace
}  // namespace quadrille
