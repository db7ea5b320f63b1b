#include "process/runtime/posed_clouds.hpp"

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <limits>
#include <memory>
#include <random>
#include <sstream>

#include "process/encode_pose.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

constexpr std::int64_t kMs = 1000;
constexpr double kSpeed = 0.5;

/// What is logged while this lives.
class LoggedLines {
 public:
  LoggedLines() {
    spdlog::set_default_logger(std::make_shared<spdlog::logger>(
        "", std::make_shared<spdlog::sinks::ostream_sink_mt>(stream_)));
  }
  ~LoggedLines() { spdlog::set_default_logger(before_); }
  bool have(const std::string& text) const { return stream_.str().find(text) != std::string::npos; }
  std::string text() const { return stream_.str(); }

 private:
  std::ostringstream stream_;
  std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
};

/// The clouds of a camera that moves along x, by what comes and when.
class MovingCamera {
 public:
  explicit MovingCamera(double max_wait = 0.05, double max_age = 1.0)
      : clouds_({"POSE", {}, max_age, max_wait}, "tracked") {}

  /// A pose of that time comes at that time of the clock.
  void pose(std::int64_t utime, std::int64_t now) {
    do_all(clouds_.take_due(Node::Time(now)));
    const double x = kSpeed * 1e-6 * static_cast<double>(utime);
    clouds_.receive_pose(test::encode_pose(utime, Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0))),
                         &refusals);
    do_all(clouds_.take_due(Node::Time(now)));
  }
  void cloud(std::int64_t utime, std::int64_t now) {
    do_all(clouds_.take_due(Node::Time(now)));
    if (const auto job = clouds_.add(utime, note_as(utime))) job->run();
    do_all(clouds_.take_due(Node::Time(now)));
  }
  void pass(std::int64_t now) { do_all(clouds_.take_due(Node::Time(now))); }

  PosedClouds::Then note_as(std::int64_t number) {
    return [this, number](const CameraPose& pose) {
      return Job{number, [this, number, pose] {
                   done.push_back(number);
                   last = pose;
                 }};
    };
  }

  /// Why clouds got no pose, and how many; empty if all did.
  std::string reasons() const {
    std::string text;
    for (const count_t& entry : clouds_.count_poseless()) {
      text += entry.name + " " + std::to_string(entry.count) + " ";
    }
    return text;
  }

  PosedClouds& clouds() { return clouds_; }

  /// In the order in which they were done.
  std::vector<std::int64_t> done;
  CameraPose last;
  Refusals refusals;

 private:
  static void do_all(const std::vector<Job>& jobs) {
    for (const Job& job : jobs) job.run();
  }

  PosedClouds clouds_;
};

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
  for (std::size_t i = 1; i <= PosedClouds::kMaxWaiting; ++i) {
    f.cloud(static_cast<std::int64_t>(i), static_cast<std::int64_t>(i));
  }
  CHECK(f.done.empty());
  f.cloud(100, 100);
  CHECK(f.done == Times{1});
  CHECK(f.last.detail.find("more than 32 clouds wait") != std::string::npos);
  f.pose(200, 200);
  CHECK(f.done.size() == PosedClouds::kMaxWaiting + 1);
  CHECK(f.clouds().poseless() == 1);
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
  fixed.add(5, keep);
  none.add(5, keep);
  REQUIRE(poses.size() == 2);
  CHECK(poses[0].X_WK->isApprox(X_WK));
  CHECK_FALSE(poses[1].X_WK);
  CHECK(none.poseless() == 0);
  CHECK(none.last_age_ms() == -1.0);
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
  const Times times = {kLeast, kLeast + 1, kLeast + 2,    -1,        0,         1,
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
  CHECK(f.done.size() >= clouds - PosedClouds::kMaxWaiting);
}

TEST_CASE("a message that is no pose is refused and counted", "[process][pose][hostile]") {
  MovingCamera f;
  f.clouds().receive_pose(std::vector<std::byte>(50), &f.refusals);
  CHECK(f.refusals.counts().total() == 1);
  CHECK(f.clouds().poses() == 1);
}

}  // namespace quadrille
