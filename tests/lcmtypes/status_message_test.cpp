#include "quadrille/bus/status_message.hpp"

#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <lcmtypes/quadrille/pose_t.hpp>

#include "quadrille/bus/encode.hpp"
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

template <class Status>
std::vector<std::byte> status_of(const std::string& sender) {
  Status status{};
  status.sender = sender;
  return encode(status);
}

TEST_CASE("the sender of a status is read, whatever sends it", "[bus][status]") {
  CHECK(read_status_sender(status_of<detector_status_t>("robot:12")) == "robot:12");
  CHECK(read_status_sender(status_of<planner_status_t>("a")) == "a");
}

TEST_CASE("what a hostile status says of its sender does no harm", "[bus][status][hostile]") {
  // Neither lines nor colours of the terminal.
  CHECK(read_status_sender(status_of<detector_status_t>("x\n\x1b[31m\xff")) ==
        "x\\x0a\\x1b[31m\\xff");
  CHECK_FALSE(read_status_sender(status_of<detector_status_t>(std::string(200, 'x'))));
  CHECK_FALSE(read_status_sender(encode(pose_t{})));
  const std::vector<std::byte> whole = status_of<detector_status_t>("robot:12");
  for (std::size_t size = 0; size < 8 + 8 + 4 + 9; ++size) {
    CHECK_FALSE(read_status_sender(std::span(whole).first(size)));
  }
}

}  // namespace
}  // namespace quadrille::bus
