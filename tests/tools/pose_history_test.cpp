#include "poses/pose_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "support/catch.hpp"

namespace quadrille {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

bus::PoseMessage history_pose(std::int64_t utime, double x = 0.0) {
  return {utime, Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0))};
}

/// The times of the poses about a time; -1 for none.
std::pair<std::int64_t, std::int64_t> bracket_times(const PoseHistory& history,
                                                    std::int64_t utime) {
  const PoseBracket bracket = history.around(utime);
  return {bracket.before ? bracket.before->utime : -1, bracket.after ? bracket.after->utime : -1};
}

using Pair = std::pair<std::int64_t, std::int64_t>;

/// Rodrigues' formula, written out.
Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle) {
  Eigen::Matrix3d K;
  K << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return Eigen::Matrix3d::Identity() + std::sin(angle) * K + (1.0 - std::cos(angle)) * K * K;
}

}  // namespace

TEST_CASE("a time lies between the last pose at or before it and the first after it",
          "[tools][pose]") {
  PoseHistory history(10.0);
  CHECK(bracket_times(history, 5) == Pair(-1, -1));
  for (const int utime : {10, 20, 30}) history.add(history_pose(utime));
  CHECK(bracket_times(history, 9) == Pair(-1, 10));
  CHECK(bracket_times(history, 10) == Pair(10, 20));
  CHECK(bracket_times(history, 29) == Pair(20, 30));
  CHECK(bracket_times(history, 30) == Pair(30, -1));
}

TEST_CASE("poses in any order within a second give the same history", "[tools][pose]") {
  std::mt19937 random(7);
  std::vector<std::int64_t> times;
  for (int i = 0; i < 100; ++i) times.push_back(10'000 * i);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(times.begin(), times.end(), random);
    PoseHistory history(10.0);
    for (const std::int64_t utime : times) history.add(history_pose(utime));
    for (int i = 0; i + 1 < 100; ++i) {
      REQUIRE(bracket_times(history, 10'000 * i + 3) == Pair(10'000 * i, 10'000 * (i + 1)));
    }
  }
}

TEST_CASE("a pose replaces one of the same time", "[tools][pose]") {
  PoseHistory history(10.0, 3);
  for (const double x : {1.0, 2.0, 3.0, 4.0}) {
    history.add(history_pose(20, x));
    history.add(history_pose(10, -x));
  }
  CHECK(history.around(20).before->X_WC.translation().x() == 4.0);
  CHECK(history.around(10).before->X_WC.translation().x() == -4.0);
}

TEST_CASE("only so many poses are kept, of so long a time", "[tools][pose]") {
  PoseHistory few(10.0, 3);
  for (int utime = 1; utime <= 10; ++utime) few.add(history_pose(utime));
  CHECK(bracket_times(few, 7) == Pair(-1, 8));
  CHECK(bracket_times(few, 8) == Pair(8, 9));
  PoseHistory brief(2.0);
  for (int i = 0; i <= 100; ++i) brief.add(history_pose(kSecond / 10 * i));
  CHECK(bracket_times(brief, 8 * kSecond - 1) == Pair(-1, 8 * kSecond));
  CHECK(bracket_times(brief, 8 * kSecond) == Pair(8 * kSecond, 8 * kSecond + kSecond / 10));
}

TEST_CASE("a pose that is older by far changes nothing, two in a row begin a new history",
          "[tools][pose]") {
  PoseHistory history(10.0);
  for (int i = 0; i <= 10; ++i) history.add(history_pose(20 * kSecond + 1000 * i));
  for (int i = 11; i <= 20; ++i) {
    history.add(history_pose(i % 2 ? 0 : kSecond * i));  // a sender whose clock is not set
    history.add(history_pose(20 * kSecond + 1000 * i));
  }
  for (int i = 0; i < 20; ++i) {
    const std::int64_t utime = 20 * kSecond + 1000 * i;
    REQUIRE(bracket_times(history, utime) == Pair(utime, utime + 1000));
  }
  // The log is played again.
  history.add(history_pose(kSecond));
  CHECK(history.newest()->utime == 20 * kSecond + 20'000);
  history.add(history_pose(kSecond + 1000));
  CHECK(bracket_times(history, kSecond + 500) == Pair(kSecond, kSecond + 1000));
  CHECK(history.newest()->utime == kSecond + 1000);
}

TEST_CASE("a pose from the far future does not poison the history for ever", "[tools][pose]") {
  PoseHistory history(10.0);
  for (int i = 0; i < 10; ++i) history.add(history_pose(1000 * i));
  history.add(history_pose(std::numeric_limits<std::int64_t>::max()));
  history.add(history_pose(std::numeric_limits<std::int64_t>::min()));
  for (int i = 10; i < 13; ++i) history.add(history_pose(1000 * i));
  CHECK(bracket_times(history, 11'500) == Pair(11'000, 12'000));
  CHECK(bracket_times(history, 12'000) == Pair(12'000, -1));
}

TEST_CASE("between two poses the origin moves along a line and the camera turns about one axis",
          "[tools][pose]") {
  std::mt19937 random(3);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
  };
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  };
  const std::int64_t start = 1'764'000'000'000'000;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d axis = vector().normalized(), p0 = vector(), p1 = vector();
    const Eigen::Matrix3d R0 = rotation_about(vector().normalized(), uniform(-3, 3));
    const double angle = i == 0 ? 0.0 : uniform(-3.1, 3.1);
    bus::PoseMessage before{start, {}}, after{start + 1 + static_cast<int>(random() % 100000), {}};
    before.X_WC = Eigen::Translation3d(p0) * Eigen::Quaterniond(R0);
    after.X_WC = Eigen::Translation3d(p1) * Eigen::Quaterniond(rotation_about(axis, angle) * R0);
    const std::int64_t span = after.utime - before.utime, at = random() % span;
    const double share = static_cast<double>(at) / static_cast<double>(span);
    const Eigen::Isometry3d X = interpolate(before, after, start + at);
    CHECK((X.translation() - ((1.0 - share) * p0 + share * p1)).norm() < 1e-12);
    CHECK((X.linear() - rotation_about(axis, share * angle) * R0).norm() < 1e-7);
    const Motion motion = motion_between(before, after);
    CHECK(motion.speed == Approx((p1 - p0).norm() / (1e-6 * static_cast<double>(span))));
    CHECK(motion.turn * 1e-6 * static_cast<double>(span) == Approx(std::abs(angle)).margin(1e-7));
  }
}

}  // namespace quadrille
