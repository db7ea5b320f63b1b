#include "poses/camera_poses.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "process/runtime/poses/moving_camera.hpp"
#include "support/catch.hpp"

namespace quadrille {

using test::kMs;
using test::LoggedLines;
using test::MovingCamera;

TEST_CASE("poses further from the cloud than the largest age are none, and the reason is told",
          "[process][pose]") {
  MovingCamera f(0.05, 0.2);
  f.pose(0, 0);
  f.cloud(201 * kMs, 201 * kMs);
  f.pass(300 * kMs);
  CHECK(f.last.detail.find("the last pose before it is 0.201 s older, more than track.pose_age = "
                           "0.2 s") == 0);
  f.pose(500 * kMs, 500 * kMs);
  f.pose(700 * kMs, 700 * kMs);
  f.pose(700 * kMs + 201 * kMs, 901 * kMs);
  for (const std::int64_t utime : {900 * kMs, 701 * kMs, 699 * kMs, 500 * kMs}) {
    f.cloud(utime, 902 * kMs);
    CHECK(f.done.back() == utime);
    CHECK(f.last.X_WK);
  }
  f.cloud(-1 * kMs, 904 * kMs);
  f.pass(1000 * kMs);
  CHECK(f.last.detail == "all poses kept are newer; do both senders use one clock?");
  f.pose(1500 * kMs, 1500 * kMs);
  f.cloud(902 * kMs, 1500 * kMs);
  f.pass(1600 * kMs);
  CHECK(f.last.detail.find("the first pose after it is 0.598 s newer, more than track.pose_age") ==
        0);
  CHECK(f.reasons() == "no_pose 1 old_pose 2 ");
}

TEST_CASE("clouds where the poses jump have none, and the reason is told", "[process][pose]") {
  const Eigen::Isometry3d off =
      GENERATE(Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.16, 0.0)),
               Eigen::Isometry3d(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY())));
  // One pose is wrong, or two in a row.
  const int wrong = GENERATE(1, 2);
  CAPTURE(wrong);
  MovingCamera f;
  for (int i = 0; i <= 20; ++i) {
    const bool is_off = i >= 10 && i < 10 + wrong;
    f.pose(33 * kMs * i, 33 * kMs * i, is_off ? off : Eigen::Isometry3d::Identity());
  }
  const auto has_pose = [&](double steps) {
    f.cloud(std::llround(33.0 * kMs * steps), 700 * kMs);
    return f.last.X_WK.has_value();
  };
  CHECK(has_pose(8.5));
  for (const double steps : {9.5, 10.0, 10.5, 9.5 + wrong}) {
    CAPTURE(steps);
    CHECK_FALSE(has_pose(steps));
    CHECK(f.last.detail.find("the poses jumped about it") == 0);
  }
  // A right pose of the very time of a cloud may follow on wrong ones.
  CHECK(has_pose(10.0 + wrong));
  CHECK(has_pose(10.5 + wrong));
  CHECK(f.reasons() == "jump 4 ");
}

TEST_CASE("slow poses that are wrong by a third of a metre are none", "[process][pose]") {
  MovingCamera f;
  for (int i = 0; i <= 10; ++i) {
    const Eigen::Isometry3d off(Eigen::Translation3d(0.0, i == 6 ? 0.35 : 0.0, 0.0));
    f.pose(100 * kMs * i, 0, off);
  }
  f.cloud(450 * kMs, 0);
  CHECK(f.last.X_WK);
  f.cloud(590 * kMs, 0);
  CHECK_FALSE(f.last.X_WK);
}

TEST_CASE("a jump that stays is believed after a second", "[process][pose]") {
  MovingCamera f;
  for (int i = 0; i <= 80; ++i) {
    const Eigen::Isometry3d off(Eigen::Translation3d(0.0, i > 30 ? 2.0 : 0.0, 0.0));
    f.pose(33 * kMs * i, 0, off);
  }
  for (const double seconds : {0.9, 1.01, 1.5, 1.9, 2.1, 2.5}) {
    CAPTURE(seconds);
    f.cloud(std::llround(1e6 * seconds), 0);
    CHECK(f.last.X_WK.has_value() == (seconds < 1.0 || seconds > 2.0));
  }
  CHECK(f.reasons() == "jump 3 ");
}

TEST_CASE("a camera that is put from place to place has the poses that are sent",
          "[process][pose]") {
  MovingCamera f;
  for (int i = 0; i <= 4; ++i) {
    f.pose(10 * kMs * i, 0, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.5 * (i % 3), 0.0)));
  }
  for (int i = 0; i <= 4; ++i) {
    f.cloud(10 * kMs * i, 0);
    REQUIRE(f.last.X_WK);
    CHECK(f.last.X_WK->translation().y() == Approx(0.5 * (i % 3)));
  }
  CHECK(f.reasons().empty());
}

TEST_CASE("poses that follow each other at once may differ by their noise", "[process][pose]") {
  MovingCamera f;
  const Eigen::Isometry3d off(Eigen::Translation3d(0.0, 0.04, 0.0));
  for (int i = 0; i <= 6; ++i) {
    f.pose(kMs * i, kMs * i, i % 2 == 0 ? off : Eigen::Isometry3d::Identity());
  }
  f.cloud(3 * kMs + 500, 10 * kMs);
  CHECK(f.last.X_WK);
  CHECK(f.reasons().empty());
}

TEST_CASE("poses that are far from the clouds of a moving camera are warned of, once in a while",
          "[process][pose]") {
  const LoggedLines log;
  MovingCamera near(1.0), far(1.0);
  for (int i = 0; i <= 20; ++i) near.pose(40 * kMs * i, 0);
  near.cloud(120 * kMs + 20 * kMs, 0);
  CHECK(log.text().empty());
  far.pose(0, 0);
  for (int i = 1; i <= 10; ++i) {
    far.pose(400 * kMs * i, 0);
    far.cloud(400 * kMs * i - 200 * kMs, 0);
  }
  CHECK(far.clouds().last_age_ms() == Approx(200.0));
  CHECK(
      log.have("POSE: poses are 200 ms from the clouds; at 0.50 m/s that is up to 100 mm; "
               "publish poses faster"));
  CHECK(log.text().find("poses are") == log.text().rfind("poses are"));
}

TEST_CASE("a camera that turns misplaces too, and one at rest does not", "[process][pose]") {
  CameraPose pose;
  pose.X_WK.emplace().setIdentity();
  pose.age = 0.2;
  CHECK(describe_if_far(pose).empty());
  pose.motion = {0.1, 0.5};
  CHECK(describe_if_far(pose).find("poses are 200 ms from the clouds; at 0.10 m/s and 29 °/s that "
                                   "is up to 120 mm a metre away; ") == 0);
  pose.age = 0.019;
  CHECK(describe_if_far(pose).empty());
}

TEST_CASE("hostile times give a pose or none, but no pose that is no number",
          "[process][pose][hostile]") {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max(),
                         kLeast = std::numeric_limits<std::int64_t>::min();
  const std::vector<std::int64_t> times = {
      kLeast, kLeast + 1, kLeast + 2,    -1,        0,         1,
      kMs,    kMost / 2,  kMost / 2 + 1, kMost - 2, kMost - 1, kMost};
  std::mt19937 random(5);
  const auto any = [&] { return times[random() % times.size()]; };
  MovingCamera f(0.05, 1e6);
  std::size_t clouds = 0;
  for (int i = 0; i < 20000; ++i) {
    if (random() % 2 == 0) {
      f.pose(any(), any());
    } else {
      f.cloud(any(), any());
      ++clouds;
    }
    if (f.last.X_WK) REQUIRE(f.last.X_WK->matrix().allFinite());
  }
  f.pass(kMost);
  CHECK(f.done.size() >= clouds - kMaxCloudsWaiting);
}

}  // namespace quadrille
