#include <functional>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/bot_core/pointcloud_t.hpp>

#include "decoders.hpp"
#include "put_int32.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

using Bytes = std::vector<std::byte>;

std::optional<RejectReason> reason_of(const Bytes& bytes) {
  return test::refusal_in(decode_cloud(bytes));
}

std::optional<RejectReason> quadrics_reason_of(const Bytes& bytes) {
  return test::refusal_in(decode_quadrics(bytes));
}

Bytes encode_changed(const std::function<void(drake::lcmt_point_cloud&)>& change) {
  auto message = test::make_wide_message(false);
  change(message);
  return encode(message);
}

/// A pointcloud_t of a frame "f" whose header stands alone.
Bytes pointcloud_header(std::int32_t points) {
  bot_core::pointcloud_t m{};
  m.frame_id = "f";
  Bytes bytes = encode(m);
  // Fingerprint, utime, seq, length of the frame and its two bytes.
  test::put_int32(bytes, 8 + 8 + 4 + 4 + 2, points);
  return bytes;
}

TEST_CASE("a message that is cut short, is lengthened or has another type is refused",
          "[bus][hostile]") {
  const std::vector<test::Decoder> all = test::all_decoders();
  for (const test::Decoder& decoder : all) {
    CAPTURE(decoder.type);
    Bytes bytes = decoder.valid;
    CHECK_FALSE(decoder.refusal(bytes));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      CAPTURE(size);
      REQUIRE(decoder.refusal(std::span(bytes).first(size)));
    }
    CHECK(decoder.refusal(std::span(bytes).first(11)) == RejectReason::kCutShort);
    bytes.push_back(std::byte{0});
    CHECK(decoder.refusal(bytes) == RejectReason::kTrailingBytes);
    bytes[3] ^= std::byte{1};
    CHECK(decoder.refusal(bytes) == RejectReason::kUnknownType);
  }
  for (std::size_t other = 0; other + 1 < all.size(); ++other) {
    CHECK(all.back().refusal(all[other].valid) == RejectReason::kUnknownType);
    CHECK(all[other].refusal(all.back().valid) == RejectReason::kUnknownType);
  }
}

TEST_CASE("a message above the limit is refused unread", "[bus][hostile]") {
  const auto refusal = [](const auto& decode, const Bytes& bytes) {
    CHECK_FALSE(test::refusal_in(decode(bytes, bytes.size())));
    return test::refusal_in(decode(bytes, bytes.size() - 1));
  };
  const Bytes cloud = encode_cloud(test::make_cloud(), CloudFormat::kDrake);
  const auto decode_colourless = [](auto bytes, auto max) { return decode_cloud(bytes, max); };
  CHECK(refusal(decode_colourless, cloud) == RejectReason::kTooLarge);
  CHECK(refusal(decode_quadrics, test::make_quadrics_bytes()) == RejectReason::kTooLarge);
  CHECK(refusal(decode_boxes, encode(to_message(test::make_cloud(), test::make_boxes()))) ==
        RejectReason::kTooLarge);
  CHECK(refusal(decode_grasps, encode(test::make_grasps())) == RejectReason::kTooLarge);
  CHECK(refusal(decode_occupancy, encode(test::make_occupancy())) == RejectReason::kTooLarge);
  const auto enlarged = [](const auto& message, std::size_t size) {
    Bytes bytes = encode(message);
    bytes.resize(size);
    return bytes;
  };
  CHECK(test::refusal_in(decode_request(enlarged(grasp_request_t{}, kMaxRequestBytes + 1))) ==
        RejectReason::kTooLarge);
  const Bytes status = enlarged(planner_status_t{}, (1 << 20) + 1);
  CHECK(test::refusal_in(decode_planner_status(status)) == RejectReason::kTooLarge);
  // So a large message of another type is known for one.
  CHECK(test::refusal_in(decode_detector_status(status)) == RejectReason::kUnknownType);
}

TEST_CASE("array lengths that are negative or overflow are refused", "[bus][hostile]") {
  // 0x40000001 * 4 wraps to 4 in 32 bits, and 0x15555556 * 12 to 8.
  const std::int32_t points =
      GENERATE(-1, std::numeric_limits<std::int32_t>::min(), 0x40000001, 0x15555556, 0x7fffffff);
  CHECK(reason_of(pointcloud_header(points)) == RejectReason::kBadLength);
}

TEST_CASE("a byte block larger than the message is refused before it is allocated",
          "[bus][hostile]") {
  bot_core::pointcloud2_t m{};
  m.fields.resize(3);
  m.nfields = 3;
  for (int i = 0; i < 3; ++i) {
    m.fields[static_cast<std::size_t>(i)].name = std::string(1, static_cast<char>('x' + i));
    m.fields[static_cast<std::size_t>(i)].datatype = 7;
  }
  Bytes bytes = encode(m);
  // The last five bytes are data_nbytes and is_dense.
  test::put_int32(bytes, bytes.size() - 5, 0x7fffffff);
  CHECK(reason_of(bytes) == RejectReason::kBadLength);
  test::put_int32(bytes, bytes.size() - 5, -1);
  CHECK(reason_of(bytes) == RejectReason::kBadLength);
}

TEST_CASE("a drake data_size beyond 32 bits is refused", "[bus][hostile]") {
  Bytes bytes = encode(test::make_wide_message(false));
  const std::size_t data_size = bytes.size() - 66 - 8;
  test::put_int32(bytes, data_size, 1);
  CHECK(reason_of(bytes) == RejectReason::kBadLength);
  test::put_int32(bytes, data_size, -1);
  CHECK(reason_of(bytes) == RejectReason::kBadLength);
}

TEST_CASE("a string of length zero, negative, or without its end mark is refused",
          "[bus][hostile]") {
  const Bytes whole = encode_cloud(test::make_cloud(), CloudFormat::kDrake);
  // Fingerprint and utime come before the frame's length, its name and its end mark.
  for (const std::int32_t length : {0, -1, 6, 1 << 30}) {
    Bytes bytes = whole;
    test::put_int32(bytes, 16, length);
    CHECK(reason_of(bytes) == RejectReason::kBadLength);
  }
}

TEST_CASE("a frame's name with a NUL in it, which cannot be sent on, is refused",
          "[bus][hostile]") {
  Bytes bytes = encode_cloud(test::make_cloud(), CloudFormat::kDrake);
  // "camera", after fingerprint, utime and its length.
  REQUIRE(bytes[20] == std::byte{'c'});
  bytes[22] = std::byte{0};
  CHECK(reason_of(bytes) == RejectReason::kBadValue);
}

TEST_CASE("layouts in which rows overlap or sizes overflow are refused", "[bus][hostile]") {
  const auto refused = [](const std::function<void(drake::lcmt_point_cloud&)>& change) {
    const auto reason = reason_of(encode_changed(change));
    return reason == RejectReason::kBadLayout || reason == RejectReason::kBadLength;
  };
  // A thousand million points out of a few bytes.
  CHECK(refused([](auto& m) { m.height = 1000000, m.width = 2, m.row_step = 1; }));
  CHECK(refused([](auto& m) { m.height = 1000000, m.width = 1000, m.row_step = 4; }));
  CHECK(refused([](auto& m) { m.width = std::numeric_limits<std::int64_t>::max(); }));
  CHECK(refused([](auto& m) { m.height = std::numeric_limits<std::int64_t>::max(); }));
  CHECK(refused([](auto& m) { m.width = -1; }));
  CHECK(refused([](auto& m) { m.height = -1, m.width = -2; }));
  CHECK(refused([](auto& m) { m.row_step = -66; }));
  CHECK(refused([](auto& m) { m.point_step = 0; }));
  CHECK(refused([](auto& m) { m.point_step = -33; }));
  CHECK(refused([](auto& m) { m.point_step = 24; }));
  CHECK(refused([](auto& m) { m.width = 3; }));
}

TEST_CASE("fields that do not give one x, y and z of floats are refused", "[bus][hostile]") {
  const std::function<void(drake::lcmt_point_cloud&)> changes[] = {
      [](auto& m) { m.fields[2].name.assign(1, 'u'); },
      [](auto& m) { m.fields[1].name.assign(1, 'x'); },
      [](auto& m) { m.fields[2].datatype = 6; },
      [](auto& m) { m.fields[2].datatype = 7; },
      [](auto& m) { m.fields[2].byte_offset = -8; },
      [](auto& m) { m.fields[2].byte_offset = 0x7fffffff; },
  };
  for (const auto& change : changes) {
    CHECK(reason_of(encode_changed(change)) == RejectReason::kBadLayout);
  }
}

TEST_CASE("more quadrics or bytes than are taken are refused", "[bus][hostile]") {
  quadrics_t m = to_message(test::make_cloud(), test::make_result());
  m.detections.resize(kMaxQuadrics, m.detections[0]);
  m.num_detections = static_cast<std::int32_t>(m.detections.size());
  CHECK(std::holds_alternative<QuadricsMessage>(decode_quadrics(encode(m))));
  m.detections.push_back(m.detections[0]);
  ++m.num_detections;
  CHECK(quadrics_reason_of(encode(m)) == RejectReason::kTooLarge);
  m = to_message(test::make_cloud(), test::make_result());
  m.warnings[0].assign(kMaxQuadricsBytes, 'w');
  CHECK(quadrics_reason_of(encode(m)) == RejectReason::kTooLarge);
}

TEST_CASE("quadrics and boxes with values without meaning are refused", "[bus][hostile]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::function<void(quadrics_t&)> changes[] = {
      [](auto& m) { m.detections[0].type = "torus"; },
      [&](auto& m) { m.detections[0].q[3] = nan; },
      [](auto& m) { m.detections[0].q[0] = 2.0; },
      [&](auto& m) { m.detections[1].pose.position[0] = nan; },
      [](auto& m) { m.detections[1].pose.quaternion[0] = 0.1; },
      [](auto& m) { m.detections[1].dimensions[0].value = 1.0 / 0.0; },
      [&](auto& m) { m.detections[1].extent_max[2] = nan; },
  };
  for (const auto& change : changes) {
    quadrics_t m = to_message(test::make_cloud(), test::make_result());
    change(m);
    CHECK(quadrics_reason_of(encode(m)) == RejectReason::kBadValue);
  }
  const boxes_t valid = to_message(test::make_cloud(), test::make_boxes());
  boxes_t infinite = valid, turned = valid;
  infinite.boxes[1].size[2] = 1.0 / 0.0;
  turned.boxes[0].pose.quaternion[0] = 2.0;
  CHECK(test::refusal_in(decode_boxes(encode(infinite))) == RejectReason::kBadValue);
  CHECK(test::refusal_in(decode_boxes(encode(turned))) == RejectReason::kBadValue);
}

}  // namespace
}  // namespace quadrille::bus
