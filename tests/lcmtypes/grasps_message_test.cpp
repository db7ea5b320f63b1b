#include "quadrille/bus/grasps_message.hpp"

#include <functional>
#include <limits>

#include "grasp_samples.hpp"
#include "put_int32.hpp"
#include "quadrille/bus/encode.hpp"
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
  REQUIRE(got.looks.size() == 1);
  CHECK(got.looks[0].pose.position[2] == -0.5);
  CHECK(got.looks[0].pose.quaternion[2] == -0.8);
  CHECK(got.looks[0].bodies == std::vector<std::int32_t>{5, 3});
  CHECK(got.looks[0].gain == 1.25);
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

TEST_CASE("a number of proposed views, or of their bodies, that the bytes cannot hold is refused",
          "[bus][grasps][looks][hostile]") {
  grasps_t m = test::make_grasps();
  m.warnings.clear();
  m.num_warnings = 0;
  const auto bytes = encode(m);
  // The view ends with the number of bodies, two of them and the gain; four bytes for the number of
  // warnings follow. The pose and the number of views come before.
  const std::size_t bodies = bytes.size() - 4 - 8 - 2 * 4 - 4, looks = bodies - 7 * 8 - 4;
  for (const std::size_t number : {bodies, looks}) {
    for (const std::int32_t count : {-1, 100, 0x40000001, 0x7fffffff}) {
      CAPTURE(number, count);
      auto changed = bytes;
      test::put_int32(changed, number, count);
      const auto decoded = decode_grasps(changed);
      REQUIRE(std::holds_alternative<Rejection>(decoded));
      CHECK(std::get<Rejection>(decoded).reason == RejectReason::kBadLength);
    }
  }
}

TEST_CASE("proposed views to which no camera can be brought are refused",
          "[bus][grasps][looks][hostile]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::function<void(look_t&)> changes[] = {
      [&](look_t& m) { m.pose.position[1] = nan; },
      [&](look_t& m) { m.pose.position[2] = infinity; },
      [&](look_t& m) { m.pose.quaternion[3] = nan; },
      [](look_t& m) { m.pose.quaternion[0] = 0.1; },
      [&](look_t& m) { m.gain = infinity; },
  };
  for (const auto& change : changes) {
    grasps_t m = test::make_grasps();
    change(m.looks[0]);
    const auto decoded = decode_grasps(encode(m));
    REQUIRE(std::holds_alternative<Rejection>(decoded));
    CHECK(std::get<Rejection>(decoded).reason == RejectReason::kBadValue);
  }
}

}  // namespace
}  // namespace quadrille::bus
