#include "process/runtime/robot/robot_history.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "process/scene_messages.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"

namespace quadrille {
namespace {

using test::ball_message;
using test::robot_bytes;

/// A camera's pose in the fixed frame, whose clouds and results are in its own frame.
Placement placed_camera() {
  Placement placement;
  placement.X_WK = Eigen::Translation3d(1.0, -2.0, 0.5) *
                   Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -2).normalized());
  return placement;
}

/// A history that is told the same ball at other places.
class BallHistory {
 public:
  explicit BallHistory(RobotState given = {}) : history_(std::move(given)) {}

  void take(std::int64_t utime, double x, const std::string& frame = "camera") {
    history_.receive("ROBOT", robot_bytes(utime, frame, {ball_message({x, 0, 1}, 0.05)}),
                     &refusals);
  }
  /// Where the ball was along x when a cloud was taken; NaN if there is none.
  double at(std::int64_t utime) const {
    const RobotShapes robot = history_.at(utime, placed_camera(), "eye");
    REQUIRE(robot.shapes.size() <= 1);
    return robot.shapes.empty() ? std::nan("") : robot.shapes[0].X_CS.translation().x();
  }
  RobotHistory& history() { return history_; }

  Refusals refusals;

 private:
  RobotHistory history_;
};

}  // namespace

TEST_CASE("a robot is where the message nearest in time says", "[process][robot]") {
  BallHistory robot;
  CHECK(std::isnan(robot.at(1000)));
  robot.take(1000, 0.1);
  robot.take(2000, 0.2);
  robot.take(3000, 0.3);
  CHECK(robot.at(1) == 0.1);
  CHECK(robot.at(1400) == 0.1);
  CHECK(robot.at(1600) == 0.2);
  CHECK(robot.at(2000) == 0.2);
  CHECK(robot.at(2501) == 0.3);
  CHECK(robot.at(9'000'000) == 0.3);
  CHECK(robot.refusals.counts().total() == 0);
}

TEST_CASE("a cloud without a time gets the newest robot", "[process][robot]") {
  BallHistory robot;
  robot.take(1000, 0.1);
  robot.take(2000, 0.2);
  CHECK(robot.at(0) == 0.2);
}

TEST_CASE("the padding is the message's, or the larger one if there are two robots",
          "[process][robot]") {
  const auto padding = [](const RobotState& given, double told) {
    RobotHistory history(given);
    Refusals refusals;
    history.receive("ROBOT", robot_bytes(0, "camera", {ball_message({0, 0, 1}, 0.05)}, told),
                    &refusals);
    return history.at(1000, placed_camera(), "eye").padding;
  };
  CHECK(padding({}, 0.003) == 0.003);
  RobotState given;
  given.frame = "camera";
  given.robot.padding = 0.02;
  given.robot.shapes.emplace_back();
  CHECK(padding(given, 0.003) == 0.02);
  CHECK(padding(given, 0.03) == 0.03);
}

TEST_CASE("a robot that is always so is no history", "[process][robot]") {
  BallHistory robot;
  robot.take(1000, 0.1);
  robot.take(0, 0.2);
  for (const std::int64_t utime : {0, 1000, 5000}) CHECK(robot.at(utime) == 0.2);
  robot.take(0, 0.25);
  CHECK(robot.at(1000) == 0.25);
  robot.take(4000, 0.3);
  for (const std::int64_t utime : {0, 1000, 5000}) CHECK(robot.at(utime) == 0.3);
}

TEST_CASE("a clock that is set back ends a robot's history", "[process][robot]") {
  BallHistory robot;
  robot.take(8000, 0.1);
  robot.take(9000, 0.2);
  robot.take(2000, 0.3);
  CHECK(robot.at(9000) == 0.3);
  CHECK(robot.at(2000) == 0.3);
  robot.take(3000, 0.4);
  CHECK(robot.at(2100) == 0.3);
  CHECK(robot.at(9000) == 0.4);
}

TEST_CASE("times at the ends of their range do not overflow", "[process][robot][hostile]") {
  BallHistory robot;
  robot.take(std::numeric_limits<std::int64_t>::min(), 0.1);
  robot.take(std::numeric_limits<std::int64_t>::max(), 0.2);
  CHECK(robot.at(std::numeric_limits<std::int64_t>::max()) == 0.2);
  CHECK(robot.at(std::numeric_limits<std::int64_t>::min()) == 0.1);
}

TEST_CASE("of a robot's many messages the newest are kept", "[process][robot]") {
  BallHistory robot;
  for (int n = 1; n <= 5000; ++n) robot.take(1000 * n, 0.001 * n);
  CHECK(robot.at(5'000'000) == Approx(5.0));
  CHECK(robot.at(4'900'000) == Approx(4.9));
  // What is older than all that are kept is where the oldest of them says.
  CHECK(robot.at(1) > 1.0);
}

TEST_CASE("a robot's shapes are brought from their frame into the camera's", "[process][robot]") {
  const Placement placement = placed_camera();
  const Eigen::Vector3d p_K(0.2, -0.1, 0.9);
  const Eigen::Vector3d p_W = *placement.X_WK * p_K;
  const auto got = [&](const std::string& frame, const Eigen::Vector3d& p) {
    RobotHistory history{RobotState{}};
    Refusals refusals;
    history.receive("ROBOT", robot_bytes(0, frame, {ball_message(p, 0.05)}), &refusals);
    REQUIRE(refusals.counts().total() == 0);
    return Eigen::Vector3d(history.at(1000, placement, "eye").shapes.at(0).X_CS.translation());
  };
  CHECK((got("camera", p_K) - p_K).norm() < 1e-12);
  CHECK((got("eye", p_K) - p_K).norm() < 1e-12);
  CHECK((got("", p_K) - p_K).norm() < 1e-12);
  CHECK((got("world", p_W) - p_K).norm() < 1e-12);
  RobotHistory elsewhere{RobotState{}};
  Refusals refusals;
  elsewhere.receive("ROBOT", robot_bytes(0, "moon", {ball_message(p_K, 0.05)}), &refusals);
  CHECK(test::error_of([&] { elsewhere.at(1000, placement, "eye"); }).find("moon") !=
        std::string::npos);
  // Without the camera's pose the fixed frame is nowhere.
  RobotHistory in_world{RobotState{}};
  in_world.receive("ROBOT", robot_bytes(0, "world", {ball_message(p_W, 0.05)}), &refusals);
  CHECK_THROWS_AS(in_world.at(1000, Placement{}, "eye"), std::invalid_argument);
  // A robot without shapes is nowhere, and needs no frame.
  in_world.receive("ROBOT", robot_bytes(0, "moon", {}), &refusals);
  CHECK(in_world.at(1000, Placement{}, "eye").shapes.empty());
}

TEST_CASE("shapes of the command line are there besides those of messages", "[process][robot]") {
  RobotState given;
  given.frame = "camera";
  SolidShape box;
  box.kind = "box";
  box.dimensions = {0.1, 0.1, 0.1};
  given.robot.shapes = {box};
  given.robot.padding = 0.02;
  given.attached = {box};
  RobotHistory history(given);
  Refusals refusals;
  REQUIRE(history.at(1, {}, "eye").shapes.size() == 1);
  CHECK(history.at(1, {}, "eye").padding == 0.02);
  const auto receive = [&](double padding) {
    history.receive("ROBOT",
                    robot_bytes(0, "", {ball_message({0, 0, 1}, 0.05)}, padding,
                                {ball_message({0, 0, -0.1}, 0.02)}),
                    &refusals);
  };
  receive(0.01);
  const RobotShapes both = history.at(1, {}, "eye");
  REQUIRE(both.shapes.size() == 2);
  CHECK(both.shapes[0].kind == "box");
  CHECK(both.shapes[1].kind == "sphere");
  CHECK(both.padding == 0.02);
  receive(0.03);
  CHECK(history.at(1, {}, "eye").padding == 0.03);
  const std::vector<SolidShape> attached = history.attached_at(1);
  REQUIRE(attached.size() == 2);
  CHECK(attached[0].kind == "box");
  CHECK(attached[1].dimensions == std::vector<double>{0.02});
}

TEST_CASE("a robot whose shapes are no solids is counted, and the one before stays",
          "[process][robot][hostile]") {
  BallHistory robot;
  robot.take(1000, 0.1);
  const auto refused = [&](const std::vector<std::byte>& bytes) {
    const std::int64_t before = robot.refusals.counts().total();
    robot.history().receive("ROBOT", bytes, &robot.refusals);
    return robot.refusals.counts().total() == before + 1;
  };
  CHECK(refused(robot_bytes(2000, "camera", {ball_message({0, 0, 1}, -0.05)})));
  CHECK(refused(robot_bytes(2000, "camera", {}, -0.001)));
  CHECK(refused(robot_bytes(2000, "camera", {}, 0.005, {ball_message({0, 0, 1}, 0.0)})));
  CHECK(refused({}));
  CHECK(robot.refusals.counts().of(bus::RejectReason::kBadValue) == 3);
  CHECK(robot.at(2000) == 0.1);
}

}  // namespace quadrille
