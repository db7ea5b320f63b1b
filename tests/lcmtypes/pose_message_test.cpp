#include "quadrille/bus/pose_message.hpp"

#include <cmath>
#include <lcmtypes/bot_core/pose_t.hpp>
#include <limits>

#include "quadrille/bus/encode.hpp"
#include "scene_samples.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

RejectReason reason_of(const bot_core::pose_t& m) {
  const auto decoded = decode_pose(encode(m));
  REQUIRE(std::holds_alternative<Rejection>(decoded));
  return std::get<Rejection>(decoded).reason;
}

TEST_CASE("a pose takes points of the camera to the fixed frame", "[bus][pose]") {
  const auto decoded = decode_pose(encode(test::make_pose()));
  REQUIRE(std::holds_alternative<PoseMessage>(decoded));
  const auto& got = std::get<PoseMessage>(decoded);
  CHECK(got.utime == 1234567);
  CHECK((got.X_WC * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(1, -1, 3)));
}

TEST_CASE("a pose is read as it was written", "[bus][pose]") {
  PoseMessage pose;
  pose.utime = 7;
  pose.X_WC.translate(Eigen::Vector3d(1, -2, 3));
  pose.X_WC.rotate(Eigen::AngleAxisd(3.0, Eigen::Vector3d(1, 2, -2).normalized()));
  const auto decoded = decode_pose(encode_pose(pose));
  REQUIRE(std::holds_alternative<PoseMessage>(decoded));
  CHECK(std::get<PoseMessage>(decoded).utime == 7);
  CHECK(std::get<PoseMessage>(decoded).X_WC.isApprox(pose.X_WC));
}

TEST_CASE("what a driver leaves out of a pose, such as velocities, may be anything",
          "[bus][pose]") {
  bot_core::pose_t m = test::make_pose();
  m.vel[1] = m.accel[2] = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::holds_alternative<PoseMessage>(decode_pose(encode(m))));
}

TEST_CASE("a pose that is none is refused", "[bus][pose][hostile]") {
  bot_core::pose_t m = test::make_pose();
  m.orientation[0] = 0.9;
  CHECK(reason_of(m) == RejectReason::kBadValue);
  m.orientation[0] = m.orientation[3] = 0.0;
  CHECK(reason_of(m) == RejectReason::kBadValue);
  m = test::make_pose();
  m.pos[2] = std::numeric_limits<double>::infinity();
  CHECK(reason_of(m) == RejectReason::kBadValue);
}

}  // namespace
}  // namespace quadrille::bus
