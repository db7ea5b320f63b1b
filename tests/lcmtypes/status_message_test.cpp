#include "quadrille/bus/status_message.hpp"

#include <lcmtypes/quadrille/pose_t.hpp>

#include "quadrille/bus/encode.hpp"
#include "status_samples.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("the status of a detector or a planner survives its message", "[bus][status]") {
  const auto decoded = decode_detector_status(encode(test::make_detector_status()));
  const auto& detector = std::get<detector_status_t>(decoded);
  CHECK(detector.superseded == 3);
  CHECK(detector.pose_age == 4.25);
  CHECK(detector.transport.dropped_datagrams == 7);
  CHECK(detector.stages[1].p99 == 41.5);
  CHECK(detector.warnings[0] == "buffer too small");
  const auto other = decode_planner_status(encode(test::make_planner_status()));
  CHECK(detector.remembered_views == 5);
  CHECK(detector.pose_correction == 0.003);
  CHECK(detector.rejected_views[0].name == "cut_short");
  CHECK(detector.rejected_knowledge[0].name == "bad_value");
  CHECK(detector.unplaced_views[0].count == 6);
  const auto& planner = std::get<planner_status_t>(other);
  CHECK(planner.unpaired_quadrics == 9);
  CHECK(planner.rejected_requests[0].name == "cut_short");
  CHECK(planner.pose_age == 7.5);
  CHECK(planner.unplaced[0].count == 4);
  CHECK(planner.remembered_views == 6);
  CHECK(planner.pose_correction == 0.002);
  CHECK(planner.rejected_views[0].name == "bad_value");
  CHECK(planner.unplaced_views[0].name == "no_pose");
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
