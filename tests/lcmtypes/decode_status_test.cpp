#include <random>

#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/occupancy_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

detector_status_t make_detector_status() {
  detector_status_t m{};
  m.sender = "robot:12:34";
  m.received = 100;
  m.superseded = 3;
  m.received_rate = 29.5;
  m.pose_age = 4.25;
  m.transport.dropped_datagrams = 7;
  m.process.version = "0.1.0";
  m.rejected = {{"bad_length", 2}};
  m.num_rejected = 1;
  m.untracked = {{"no_pose", 5}};
  m.num_untracked = 1;
  m.stages.resize(2);
  m.stages[1].name = "quadrics";
  m.stages[1].p99 = 41.5;
  m.num_stages = 2;
  m.warnings = {"buffer too small"};
  m.num_warnings = 1;
  return m;
}

planner_status_t make_planner_status() {
  planner_status_t m{};
  m.sender = "robot:12:35";
  m.unpaired_quadrics = 9;
  m.published_rate = 4.5;
  m.rejected_requests = {{"cut_short", 1}};
  m.num_rejected_requests = 1;
  m.pose_age = 7.5;
  m.unplaced = {{"late_pose", 4}};
  m.num_unplaced = 1;
  m.stages.resize(1);
  m.stages[0].name = "grasps";
  m.num_stages = 1;
  return m;
}

occupancy_t make_occupancy() {
  occupancy_t m{};
  m.utime = 5;
  m.frame = "camera";
  m.resolution = 0.005;
  m.data = {1, 2, 3};
  m.data_size = 3;
  return m;
}

/// Every beginning of a message is refused, and so is one with a byte more.
template <class Decode>
void check_lengths(std::vector<std::byte> bytes, const Decode& decode) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CAPTURE(size);
    REQUIRE(std::holds_alternative<Rejection>(decode(std::span(bytes).first(size))));
  }
  bytes.push_back(std::byte{0});
  const auto decoded = decode(bytes);
  REQUIRE(std::holds_alternative<Rejection>(decoded));
  CHECK(std::get<Rejection>(decoded).reason == RejectReason::kTrailingBytes);
}

/// Whatever bytes are flipped, the answer is a message or a refusal.
template <class Decode>
void check_flips(const std::vector<std::byte>& whole, const Decode& decode) {
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    auto bytes = whole;
    for (int n = 0; n < 3; ++n)
      bytes[8 + random() % (bytes.size() - 8)] = static_cast<std::byte>(random());
    decode(bytes);
  }
}

}  // namespace

TEST_CASE("a detector's status survives its message, and no damaged one passes",
          "[bus][status][hostile]") {
  const auto bytes = encode(make_detector_status());
  const auto decoded = decode_detector_status(bytes);
  REQUIRE(std::holds_alternative<detector_status_t>(decoded));
  const auto& got = std::get<detector_status_t>(decoded);
  CHECK(got.superseded == 3);
  CHECK(got.pose_age == 4.25);
  CHECK(got.transport.dropped_datagrams == 7);
  CHECK(got.stages[1].p99 == 41.5);
  CHECK(got.warnings[0] == "buffer too small");
  const auto decode = [](std::span<const std::byte> b) { return decode_detector_status(b); };
  check_lengths(bytes, decode);
  check_flips(bytes, decode);
  CHECK(std::holds_alternative<Rejection>(decode_planner_status(bytes)));
}

TEST_CASE("a planner's status survives its message, and no damaged one passes",
          "[bus][status][hostile]") {
  const auto bytes = encode(make_planner_status());
  const auto decoded = decode_planner_status(bytes);
  REQUIRE(std::holds_alternative<planner_status_t>(decoded));
  CHECK(std::get<planner_status_t>(decoded).unpaired_quadrics == 9);
  CHECK(std::get<planner_status_t>(decoded).rejected_requests[0].name == "cut_short");
  CHECK(std::get<planner_status_t>(decoded).pose_age == 7.5);
  CHECK(std::get<planner_status_t>(decoded).unplaced[0].count == 4);
  const auto decode = [](std::span<const std::byte> b) { return decode_planner_status(b); };
  check_lengths(bytes, decode);
  check_flips(bytes, decode);
}

TEST_CASE("a map of space survives its message, and no damaged one passes",
          "[bus][occupancy][hostile]") {
  const auto bytes = encode(make_occupancy());
  const auto decoded = decode_occupancy(bytes);
  REQUIRE(std::holds_alternative<occupancy_t>(decoded));
  CHECK(std::get<occupancy_t>(decoded).data == std::vector<std::uint8_t>{1, 2, 3});
  const auto decode = [](std::span<const std::byte> b) { return decode_occupancy(b); };
  check_lengths(bytes, decode);
  check_flips(bytes, decode);
  auto flat = make_occupancy();
  flat.resolution = 0.0;
  CHECK(std::holds_alternative<Rejection>(decode_occupancy(encode(flat))));
}

TEST_CASE("messages that are too large, or of another type, are told by the reason",
          "[bus][status][occupancy][hostile]") {
  const auto reason = [](const auto& decoded) { return std::get<Rejection>(decoded).reason; };
  const auto map = encode(make_occupancy());
  const auto status = encode(make_detector_status());
  CHECK(reason(decode_occupancy(map, map.size() - 1)) == RejectReason::kTooLarge);
  CHECK(reason(decode_occupancy(status)) == RejectReason::kUnknownType);
  CHECK(reason(decode_detector_status(map)) == RejectReason::kUnknownType);
}

}  // namespace quadrille::bus
