#include "quadrille/bus/grasps_message.hpp"

#include "samples.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("grasps survive their message", "[bus][grasps]") {
  const auto decoded = decode_grasps(encode(test::make_grasps()));
  REQUIRE(std::holds_alternative<grasps_t>(decoded));
  const auto& got = std::get<grasps_t>(decoded);
  CHECK(got.utime == 77);
  CHECK(got.gripper == "franka");
  REQUIRE(got.grasps.size() == 2);
  CHECK(got.grasps[1].target == 3);
  CHECK(got.grasps[1].width == 0.05);
  CHECK(got.rejected[0].count == 9);
  REQUIRE(got.targets.size() == 2);
  CHECK(got.targets[0].num_grasps == 2);
  CHECK(got.targets[1].target == 5);
  CHECK(got.targets[1].furthest == "width");
  CHECK(got.targets[1].rejected[0].name == "width");
  REQUIRE(got.remedies.size() == 1);
  CHECK(got.remedies[0].change == "--gripper wsg50");
  CHECK(got.remedies[0].num_grasps == 4);
  CHECK(got.remedies[0].score == 0.75);
  CHECK(got.warnings == std::vector<std::string>{"few points"});
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

}  // namespace
}  // namespace quadrille::bus
