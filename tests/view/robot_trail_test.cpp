#include "view/live/robot_trail.hpp"

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

TEST_CASE("a cloud gets the robot's message that is nearest in time", "[view][robot]") {
  view::RobotTrail trail;
  CHECK(trail.at(100) == nullptr);
  for (const std::int64_t utime : {100, 200, 300}) trail.add(robot_bytes_at(utime));
  CHECK(trail.at(220)->utime == 200);
  CHECK(trail.at(999)->utime == 300);
  CHECK(trail.at(0)->utime == 300);
  // The clock was set back.
  trail.add(robot_bytes_at(50));
  CHECK(trail.at(220)->utime == 50);
  // Shapes without a time hold always, so they take the place of all before them.
  trail.add(robot_bytes_at(0));
  CHECK(trail.at(50)->utime == 0);
  trail.add(robot_bytes_at(70));
  CHECK(trail.at(1)->utime == 70);
}

TEST_CASE("the robot's messages do not fill the memory", "[view][robot][hostile]") {
  view::RobotTrail trail;
  const auto most = static_cast<std::int64_t>(view::RobotTrail::kMaxMessages);
  for (std::int64_t utime = 1; utime <= most + 10; ++utime) trail.add(robot_bytes_at(utime));
  CHECK(trail.at(1)->utime == 11);
  robot_t large{};
  large.attached.resize(200);
  for (auto& shape : large.attached) {
    shape.pose.quaternion[0] = 1.0;
    shape.dimensions.resize(500);
    shape.num_dimensions = 500;
  }
  large.num_attached = 200;
  for (std::int64_t utime = 1000; utime < 1010; ++utime) {
    large.utime = utime;
    trail.add(bus::encode(large));
  }
  const auto kept =
      static_cast<std::int64_t>(view::RobotTrail::kMaxBytes / bus::encode(large).size());
  REQUIRE(kept < 10);
  CHECK(trail.at(1)->utime == 1010 - kept);
  trail.add(std::vector<std::byte>(100, std::byte{0xff}));
  CHECK(trail.at(2000)->utime == 1009);
}
