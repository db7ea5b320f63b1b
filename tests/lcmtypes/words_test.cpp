#include "support/words.hpp"

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("each value of the bus's enumerations has a word of its own", "[bus][words]") {
  test::check_words(CloudFormat::kPointCloud);
  test::check_words(CloudColours::kKeep);
  test::check_words(RejectReason::kInternal);

  CHECK(to_string(CloudColours::kDrop) == "drop");
  CHECK(to_string(RejectReason::kTrailingBytes) == "trailing_bytes");
}

}  // namespace
}  // namespace quadrille::bus
