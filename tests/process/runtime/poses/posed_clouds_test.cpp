#include "process/runtime/poses/posed_clouds.hpp"

#include "process/runtime/poses/moving_camera.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

using test::kMs;
using test::kSpeed;
using test::LoggedLines;
using test::MovingCamera;
using Times = std::vector<std::int64_t>;

}  // namespace

TEST_CASE("a cloud between two poses that are there gets the pose between them at once",
          "[process][pose]") {
  MovingCamera f;
  for (int i = 0; i < 10; ++i) f.pose(10 * kMs * i, 10 * kMs * i);
  f.cloud(43 * kMs, 100 * kMs);
  CHECK(f.done == Times{43 * kMs});
  REQUIRE(f.last.X_WK);
  CHECK(f.last.X_WK->translation().x() == Approx(kSpeed * 0.043).epsilon(1e-12));
  CHECK(*f.last.age == Approx(0.003));
  CHECK(f.clouds().last_age_ms() == Approx(3.0));
  CHECK(f.clouds().poseless() == 0);
}

TEST_CASE("a pose of exactly the cloud's time needs no other", "[process][pose]") {
  MovingCamera f(0.0);
  f.pose(10 * kMs, 10 * kMs);
  f.cloud(10 * kMs, 12 * kMs);
  CHECK(f.last.X_WK->translation().x() == kSpeed * 0.01);
  CHECK(f.clouds().last_age_ms() == 0.0);
}

TEST_CASE("a cloud waits for the pose after it, and others wait in their order",
          "[process][pose]") {
  MovingCamera f;
  f.pose(0, 0);
  f.cloud(5 * kMs, 5 * kMs);
  f.cloud(15 * kMs, 15 * kMs);
  f.cloud(8 * kMs, 16 * kMs);
  CHECK(f.done.empty());
  f.pose(10 * kMs, 20 * kMs);
  CHECK(f.done == Times{5 * kMs});
  // The third has its poses, but the second came before it.
  f.pose(20 * kMs, 30 * kMs);
  CHECK(f.done == Times{5 * kMs, 15 * kMs, 8 * kMs});
  CHECK(f.last.X_WK->translation().x() == Approx(kSpeed * 0.008).epsilon(1e-12));
  CHECK(f.clouds().poseless() == 0);
}

TEST_CASE("a cloud that has waited long enough gets no pose, whatever comes then",
          "[process][pose]") {
  const LoggedLines log;
  MovingCamera f;
  for (int i = 0; i <= 10; ++i) f.pose(10 * kMs * i, 200 * kMs + 10 * kMs * i);
  f.cloud(300 * kMs, 300 * kMs);
  f.pass(350 * kMs);
  CHECK(f.done.empty());
  f.pose(310 * kMs, 350 * kMs + 1);
  CHECK(f.done == Times{300 * kMs});
  CHECK_FALSE(f.last.X_WK);
  CHECK(f.reasons() == "late_pose 1 ");
  CHECK(f.clouds().last_age_ms() == Approx(200.0));
  CHECK(
      log.have("POSE: cloud 300000 is not tracked: the newest pose is 200 ms older; at 0.50 m/s "
               "that is up to 100 mm, and none after the cloud came within track.pose_wait = "
               "0.05 s; raise that, or publish poses faster; for a camera at rest give "
               "--camera-pose instead"));
  CHECK(f.clouds().find_oddity(3) ==
        "1 of 3 clouds had no pose of the camera (late_pose 1) and were not tracked");
}

TEST_CASE("a pose that comes when the wait is just over in time still counts", "[process][pose]") {
  MovingCamera f;
  f.pose(0, 0);
  f.cloud(5 * kMs, 5 * kMs);
  f.pose(55 * kMs, 55 * kMs);
  REQUIRE(f.last.X_WK);
  // By the clock of the messages that come, and not by their own.
  f.cloud(60 * kMs, 1000 * kMs);
  f.pose(70 * kMs, 1050 * kMs);
  CHECK(f.last.X_WK->translation().x() == Approx(kSpeed * 0.06).epsilon(1e-12));
}

TEST_CASE("without a wait a cloud has its poses at once or not at all", "[process][pose]") {
  MovingCamera f(0.0);
  f.pose(0, 0);
  f.cloud(5 * kMs, 5 * kMs);
  CHECK(f.done == Times{5 * kMs});
  CHECK_FALSE(f.last.X_WK);
}

TEST_CASE("disorder of a few milliseconds and late clouds lose nothing", "[process][pose]") {
  MovingCamera f;
  std::size_t clouds = 0;
  for (int i = 0; i < 800; ++i) {
    const std::int64_t now = 10 * kMs * i;
    // One pose in twenty comes after the next one.
    if (i % 20 != 0) f.pose(now, now);
    if (i % 20 == 1) f.pose(now - 10 * kMs, now + kMs);
    if (i < 20 || i % 10 != 0) continue;
    f.cloud(now - 100 * kMs + 3 * kMs, now + 3 * kMs);
    REQUIRE(f.done.size() == ++clouds);
    const double x = kSpeed * 1e-6 * static_cast<double>(f.done.back());
    REQUIRE(f.last.X_WK->translation().x() == Approx(x).epsilon(1e-12));
  }
  CHECK(clouds == 78);
  CHECK(f.clouds().poseless() == 0);
}

TEST_CASE("only so many clouds wait", "[process][pose]") {
  MovingCamera f(10.0);
  f.pose(0, 0);
  for (std::size_t i = 1; i <= kMaxCloudsWaiting; ++i) {
    f.cloud(static_cast<std::int64_t>(i), static_cast<std::int64_t>(i));
  }
  CHECK(f.done.empty());
  f.cloud(100, 100);
  CHECK(f.done == Times{1});
  CHECK(f.last.detail.find("more than 32 clouds wait") != std::string::npos);
  f.pose(200, 200);
  CHECK(f.done.size() == kMaxCloudsWaiting + 1);
  CHECK(f.clouds().poseless() == 1);
}

TEST_CASE("clouds that wait take only so much memory", "[process][pose]") {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  MovingCamera f(10.0, 1.0, 100 * kMiB);
  f.pose(0, 0);
  // The newest may wait, however large it is.
  f.cloud(1, 1, 300 * kMiB);
  CHECK(f.done.empty());
  f.cloud(2, 2, 40 * kMiB);
  CHECK(f.done == Times{1});
  CHECK(f.last.detail.find("more than 100 MiB of clouds wait") != std::string::npos);
  f.cloud(3, 3, 40 * kMiB);
  CHECK(f.done == Times{1});
  f.cloud(4, 4, 90 * kMiB);
  CHECK(f.done == Times{1, 2, 3});
  f.pose(200, 200);
  CHECK(f.done == Times{1, 2, 3, 4});
  CHECK(f.clouds().poseless() == 3);
}

TEST_CASE("what follows a cloud that waits is done right after it", "[process][pose]") {
  MovingCamera f;
  f.pose(0, 0);
  CHECK_FALSE(f.clouds().follow(5 * kMs, f.note_as(1)));
  f.cloud(5 * kMs, 5 * kMs);
  f.cloud(6 * kMs, 6 * kMs);
  CHECK(f.clouds().follow(5 * kMs, f.note_as(1)));
  CHECK_FALSE(f.clouds().follow(7 * kMs, f.note_as(2)));
  f.pose(10 * kMs, 10 * kMs);
  CHECK(f.done == Times{5 * kMs, 1, 6 * kMs});
}

TEST_CASE("a camera at rest, or one of which nothing is told, keeps no cloud waiting",
          "[process][pose]") {
  const Eigen::Isometry3d X_WK(Eigen::Translation3d(1, 2, 3));
  PosedClouds fixed({"POSE", X_WK, 1.0, 0.05}, "tracked"), none({"", {}, 1.0, 0.05}, "tracked");
  std::vector<CameraPose> poses;
  const PosedClouds::Then keep = [&](const CameraPose& pose) {
    poses.push_back(pose);
    return std::nullopt;
  };
  fixed.add(5, 0, keep);
  none.add(5, 0, keep);
  REQUIRE(poses.size() == 2);
  CHECK(poses[0].X_WK->isApprox(X_WK));
  CHECK_FALSE(poses[1].X_WK);
  CHECK(none.poseless() == 0);
  CHECK(none.last_age_ms() == -1.0);
}

TEST_CASE("a message that is no pose is refused and counted", "[process][pose][hostile]") {
  MovingCamera f;
  f.clouds().receive_pose(std::vector<std::byte>(50), &f.refusals);
  CHECK(f.refusals.counts().total() == 1);
  CHECK(f.clouds().poses() == 1);
}

}  // namespace quadrille
