#include "poses/robot_trail.hpp"

#include <lcmtypes/quadrille/robot_t.hpp>

#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// The bytes of a message whose frame has this name.
std::vector<std::byte> robot_bytes_at(std::int64_t utime, const std::string& frame = "camera") {
  robot_t message{};
  message.utime = utime;
  message.frame = frame;
  return bus::encode(message);
}

}  // namespace

TEST_CASE("a cloud gets the robot's message that is nearest in time", "[pose][robot]") {
  RobotTrail trail;
  CHECK(trail.at(100) == nullptr);
  for (const std::int64_t utime : {100, 200, 300}) CHECK(!trail.add(robot_bytes_at(utime)));
  CHECK(trail.at(220)->utime == 200);
  CHECK(trail.at(999)->utime == 300);
  CHECK(trail.at(0)->utime == 300);
  // The clock was set back.
  CHECK(!trail.add(robot_bytes_at(50)));
  CHECK(trail.at(220)->utime == 50);
  // Shapes without a time hold always, so they take the place of all before them.
  CHECK(!trail.add(robot_bytes_at(0)));
  CHECK(trail.at(50)->utime == 0);
  CHECK(!trail.add(robot_bytes_at(70)));
  CHECK(trail.at(1)->utime == 70);
}

TEST_CASE("the robot's messages do not fill the memory, and bad ones are refused",
          "[pose][robot][hostile]") {
  RobotTrail trail;
  const auto most = static_cast<std::int64_t>(RobotTrail::kMaxStates);
  for (std::int64_t utime = 1; utime <= most + 10; ++utime)
    CHECK(!trail.add(robot_bytes_at(utime)));
  CHECK(trail.at(1)->utime == 11);
  CHECK(trail.add(std::vector<std::byte>(100, std::byte{0xff}))->reason ==
        bus::RejectReason::kUnknownType);
  robot_t bad{};
  bad.utime = most + 11;
  bad.shapes.resize(1);
  bad.shapes[0].kind = "sphere";
  bad.shapes[0].pose.quaternion[0] = 1.0;
  bad.num_shapes = 1;
  CHECK(trail.add(bus::encode(bad))->reason == bus::RejectReason::kBadValue);
  CHECK(trail.at(2000)->utime == most + 10);
}
