#include "quadrille/bus/grasps_message.hpp"

#include "samples.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

grasps_t make_grasps() {
  grasps_t m{};
  m.utime = 77;
  m.seq = 4;
  m.frame = "camera";
  m.gripper = "franka";
  m.unknown = "obstacle";
  m.grasps.resize(2);
  m.grasps[1].target = 3;
  m.grasps[1].width = 0.05;
  m.num_grasps = 2;
  m.rejected.resize(1);
  m.rejected[0].name = "width";
  m.rejected[0].count = 9;
  m.num_rejected = 1;
  m.warnings = {"few points"};
  m.num_warnings = 1;
  return m;
}

TEST_CASE("grasps survive their message", "[bus][grasps]") {
  const auto decoded = decode_grasps(encode(make_grasps()));
  REQUIRE(std::holds_alternative<grasps_t>(decoded));
  const auto& got = std::get<grasps_t>(decoded);
  CHECK(got.utime == 77);
  CHECK(got.gripper == "franka");
  REQUIRE(got.grasps.size() == 2);
  CHECK(got.grasps[1].target == 3);
  CHECK(got.grasps[1].width == 0.05);
  CHECK(got.rejected[0].count == 9);
  CHECK(got.warnings == std::vector<std::string>{"few points"});
}

TEST_CASE("grasps that are cut short or lengthened are refused", "[bus][grasps][hostile]") {
  const auto whole = encode(make_grasps());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    const auto decoded = decode_grasps(std::span(whole).first(size));
    REQUIRE(std::holds_alternative<Rejection>(decoded));
  }
  auto longer = whole;
  longer.push_back(std::byte{0});
  const auto decoded = decode_grasps(longer);
  REQUIRE(std::holds_alternative<Rejection>(decoded));
  CHECK(std::get<Rejection>(decoded).reason == RejectReason::kTrailingBytes);
}

TEST_CASE("a number of grasps that the bytes cannot hold is refused", "[bus][grasps][hostile]") {
  grasps_t m{};
  auto bytes = encode(m);
  // The fingerprint, utime, seq and three empty strings come before the number.
  const std::size_t number = 8 + 8 + 4 + 3 * 5;
  for (const std::int32_t count : {-1, 1, 0x7fffffff}) {
    CAPTURE(count);
    test::put_int32(bytes, number, count);
    const auto decoded = decode_grasps(bytes);
    REQUIRE(std::holds_alternative<Rejection>(decoded));
    CHECK(std::get<Rejection>(decoded).reason == RejectReason::kBadLength);
  }
}

TEST_CASE("quadrics are no grasps, and too many bytes are not looked at", "[bus][grasps]") {
  const auto quadrics = decode_grasps(test::make_quadrics_bytes());
  CHECK(std::get<Rejection>(quadrics).reason == RejectReason::kUnknownType);
  const auto large = decode_grasps(encode(make_grasps()), 100);
  CHECK(std::get<Rejection>(large).reason == RejectReason::kTooLarge);
}

}  // namespace
}  // namespace quadrille::bus
