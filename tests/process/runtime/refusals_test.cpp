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
  CHECK(refusals.accept("A", bus::Decoded<std::string>("sound")) == "sound");
  CHECK(refusals.counts().total() == 3);
  const bus::Decoded<std::string> refused = bus::Rejection{bus::RejectReason::kCutShort, "y"};
  CHECK_FALSE(refusals.accept("A", refused));
  CHECK(refusals.counts().total() == 4);
}

}  // namespace
}  // namespace quadrille
