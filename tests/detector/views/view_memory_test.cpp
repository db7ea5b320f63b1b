// Which views a memory keeps and for how long, and how it corrects the poses of new ones.
#include "quadrille/detector/view_memory.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "detector/views/taken_views.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/error_of.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

double angle_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool same_bits(const PointCloud& a, const PointCloud& b) {
  return a.width == b.width && a.height == b.height && a.points.size() == b.points.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof a.points[0]) == 0 &&
         a.viewpoint == b.viewpoint;
}

}  // namespace

TEST_CASE("a view from nearly the same direction takes the place of the one before",
          "[views][memory]") {
  ViewMemory memory;
  CHECK(views_in_world(memory).empty());
  add_view(memory, 1 * kSecond, taken_from_eye(world_table(), eye_at(0)));
  REQUIRE(memory.size() == 1);
  CHECK(memory.others(1 * kSecond, Eigen::Isometry3d::Identity()).empty());
  const Taken near = taken_from_eye(world_table(), eye_at(4));
  add_view(memory, 2 * kSecond, near);
  REQUIRE(memory.size() == 1);
  CHECK((views_in_world(memory)[0].viewpoint - eye_at(4)).norm() < 0.01);
  // Nearer to the table, but from the same direction.
  const Eigen::Vector3d closer = 0.8 * eye_at(2);
  add_view(memory, 3 * kSecond, taken_from_eye(world_table(), closer));
  REQUIRE(memory.size() == 1);
  CHECK((views_in_world(memory)[0].viewpoint - closer).norm() < 0.01);

  add_view(memory, 4 * kSecond, taken_from_eye(world_table(), eye_at(70)));
  CHECK(memory.size() == 2);
  const Taken last = taken_from_eye(world_table(), eye_at(140));
  add_view(memory, 5 * kSecond, last);
  REQUIRE(memory.size() == 3);
  // The newest comes first, and in the frame that is asked for.
  const std::vector<PointCloud> others = memory.others(5 * kSecond, last.X_WK);
  REQUIRE(others.size() == 2);
  CHECK((last.X_WK * others[0].viewpoint - eye_at(70)).norm() < 0.01);
  CHECK((last.X_WK * others[1].viewpoint - closer).norm() < 0.01);
}

TEST_CASE("a view between two directions is used, and not kept", "[views][memory]") {
  ViewMemory memory;
  add_view(memory, 1 * kSecond, taken_from_eye(world_table(), eye_at(0)));
  // The angle about the vertical is larger than the one between the lines of sight.
  const Eigen::Vector3d eye = eye_at(14);
  const double angle = angle_of(eye, eye_at(0));
  REQUIRE(angle > 0.55 * 0.26);
  REQUIRE(angle < 0.95 * 0.26);
  const Taken between = taken_from_eye(world_table(), eye);
  add_view(memory, 2 * kSecond, between);
  CHECK(memory.size() == 1);
  CHECK(memory.others(2 * kSecond, between.X_WK).size() == 1);
  CHECK((views_in_world(memory)[0].viewpoint - eye_at(0)).norm() < 0.01);
}

TEST_CASE("a camera that turns slowly leaves views behind, one in each sector", "[views][memory]") {
  DetectorOptions options;
  options.views.most = 64;
  options.views.sector = GENERATE(0.26, 0.5);
  const double sector = options.views.sector;
  ViewMemory memory(options);
  constexpr double kStep = 3.0, kTurn = 150.0;
  double way = 0.0;
  for (double degrees = 0.0; degrees <= kTurn; degrees += kStep) {
    const std::int64_t utime = static_cast<std::int64_t>((1.0 + degrees / 100.0) * kSecond);
    add_view(memory, utime, taken_from_eye(world_table(), eye_at(degrees), 0.001, 96));
    if (degrees > 0.0) way += angle_of(eye_at(degrees), eye_at(degrees - kStep));
  }
  const double step = angle_of(eye_at(0), eye_at(kStep));
  const std::vector<PointCloud> views = views_in_world(memory);
  CAPTURE(way, sector, views.size());
  // Where one camera sees a little farther than another, the middle of what it sees differs.
  constexpr double kLoose = 0.05;
  CHECK(static_cast<double>(views.size()) >= std::floor(way / (sector + step + kLoose)));
  CHECK(static_cast<double>(views.size()) <= std::ceil(way / (sector - kLoose)) + 1.0);
  for (std::size_t a = 0; a < views.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      CHECK(angle_of(views[a].viewpoint, views[b].viewpoint) > 0.5 * sector - kLoose);
    }
  }
  for (double degrees = 0.0; degrees <= kTurn; degrees += kStep) {
    double nearest = M_PI;
    for (const PointCloud& view : views) {
      nearest = std::min(nearest, angle_of(view.viewpoint, eye_at(degrees)));
    }
    CHECK(nearest < sector + kLoose);
  }
}

TEST_CASE("a camera that looks elsewhere from the same direction adds a view", "[views][memory]") {
  ViewMemory memory;
  const Taken here = taken_from_eye(world_table(), eye_at(0));
  add_view(memory, 1 * kSecond, here);
  Taken there = here;
  there.X_WK = Eigen::Translation3d(2.0, 0.0, 0.0) * here.X_WK;
  add_view(memory, 2 * kSecond, there);
  CHECK(memory.size() == 2);
}

TEST_CASE("of many views the newest are kept", "[views][memory]") {
  DetectorOptions options;
  options.views.most = 3;
  ViewMemory memory(options);
  for (int n = 0; n < 5; ++n) {
    add_view(memory, (1 + n) * kSecond, taken_from_eye(world_table(), eye_at(60.0 * n)));
    CHECK(memory.size() == static_cast<std::size_t>(std::min(n + 1, 3)));
  }
  const std::vector<PointCloud> views = views_in_world(memory);
  REQUIRE(views.size() == 3);
  for (int n = 0; n < 3; ++n) {
    CHECK((views[n].viewpoint - eye_at(60.0 * (4 - n))).norm() < 0.01);
  }
}

TEST_CASE("views fade with time", "[views][memory]") {
  DetectorOptions options;
  options.views.remember = 10.0;
  ViewMemory memory(options);
  add_view(memory, 100 * kSecond, taken_from_eye(world_table(), eye_at(0)));
  add_view(memory, 105 * kSecond, taken_from_eye(world_table(), eye_at(90)));
  add_view(memory, 110 * kSecond, taken_from_eye(world_table(), eye_at(180)));
  CHECK(memory.size() == 3);
  add_view(memory, 110 * kSecond + 1, taken_from_eye(world_table(), eye_at(180)));
  CHECK(memory.size() == 2);
  // Even a cloud that shows nothing tells the time.
  memory.add(116 * kSecond, {}, Eigen::Isometry3d::Identity());
  REQUIRE(memory.size() == 1);
  CHECK((views_in_world(memory)[0].viewpoint - eye_at(180)).norm() < 0.01);
}

TEST_CASE("nothing is remembered for no time", "[views][memory]") {
  DetectorOptions options;
  options.views.remember = 0.0;
  ViewMemory memory(options);
  add_view(memory, 1 * kSecond, taken_from_eye(world_table(), eye_at(0)));
  Taken off = taken_from_eye(world_table(), eye_at(90));
  off.X_WK = Eigen::Translation3d(0.003, 0.0, 0.0) * off.X_WK;
  CHECK(add_view(memory, 2 * kSecond, off).matrix().isIdentity(0.0));
  CHECK(memory.size() == 0);
  CHECK(memory.others(2 * kSecond, off.X_WK).empty());
}

TEST_CASE("a clock that is set back forgets what is later", "[views][memory]") {
  ViewMemory memory;
  add_view(memory, 50 * kSecond, taken_from_eye(world_table(), eye_at(0)));
  add_view(memory, 51 * kSecond, taken_from_eye(world_table(), eye_at(90)));
  REQUIRE(memory.size() == 2);
  add_view(memory, 50 * kSecond, taken_from_eye(world_table(), eye_at(180)));
  REQUIRE(memory.size() == 1);
  CHECK((views_in_world(memory)[0].viewpoint - eye_at(180)).norm() < 0.01);
}

TEST_CASE("poses that are off are corrected by what earlier views saw", "[views][memory]") {
  const Eigen::Vector3d axis(0.6, -0.48, 0.64);
  const double sign = GENERATE(1.0, -1.0);
  ViewMemory memory;
  const Taken first = taken_from_eye(world_table(), eye_at(0), 0.001, 320);
  CHECK(add_view(memory, 1 * kSecond, first).matrix().isIdentity(0.0));
  const Taken second = taken_from_eye(world_table(), eye_at(60), 0.001, 320);
  // A turn of 0.2 degrees about the camera, and a shift of 2 mm.
  const Eigen::Vector3d eye = second.X_WK.translation();
  const Eigen::Isometry3d error =
      Eigen::Translation3d(eye + 0.002 * Eigen::Vector3d(0.64, 0.6 * sign, 0.48)) *
      Eigen::AngleAxisd(sign * 0.2 * M_PI / 180.0, axis) * Eigen::Translation3d(-eye);
  const Eigen::Isometry3d X_WK_off = error * second.X_WK;
  const Eigen::Isometry3d motion = memory.add(2 * kSecond, second.cloud, X_WK_off);
  const Eigen::Isometry3d rest = motion * error;
  const std::vector<Eigen::Vector3d> places = {{0, 0, 0}, {0.2, 0, 0.1}, {-0.2, 0, 0.06}};
  for (const Eigen::Vector3d& p : places) {
    CAPTURE(p.transpose());
    CHECK((error * p - p).norm() > 0.0014);
    CHECK((rest * p - p).norm() < 0.0007);
  }
  // The other view lies where it truly is from the camera, not where the pose says.
  const std::vector<PointCloud> others = memory.others(2 * kSecond, X_WK_off);
  REQUIRE(others.size() == 1);
  const Eigen::Isometry3d X_KFirst = second.X_WK.inverse() * first.X_WK;
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < others[0].points.size(); ++k) {
    if (!others[0].points[k].allFinite()) continue;
    const Eigen::Vector3d truth = X_KFirst * first.cloud.points[k].cast<double>();
    sum += (others[0].points[k].cast<double>() - truth).norm();
    ++count;
  }
  REQUIRE(count > 20000);
  CHECK(sum / count < 0.001);
}

TEST_CASE("the same views give the same bits", "[views][memory][determinism]") {
  const auto remembered = [](int threads) {
    DetectorOptions options;
    options.threads = threads;
    ViewMemory memory(options);
    Eigen::Matrix4d motions = Eigen::Matrix4d::Zero();
    for (int n = 0; n < 4; ++n) {
      Taken view = taken_from_eye(n < 2 ? world_table() : world_without_ball(), eye_at(50.0 * n));
      view.X_WK = Eigen::Translation3d(0.001 * n, 0.0, -0.001) * view.X_WK;
      motions += add_view(memory, (1 + n) * kSecond, view).matrix();
    }
    return std::make_pair(views_in_world(memory), motions);
  };
  const auto once = remembered(1);
  REQUIRE(once.first.size() == 4);
  for (const int threads : {1, 2, 4}) {
    const auto again = remembered(threads);
    REQUIRE(again.first.size() == once.first.size());
    CHECK(again.second == once.second);
    for (std::size_t v = 0; v < once.first.size(); ++v) {
      CHECK(same_bits(again.first[v], once.first[v]));
    }
  }
}

TEST_CASE("clouds without a viewpoint or without points are not remembered",
          "[views][memory][hostile]") {
  ViewMemory memory;
  const Taken good = taken_from_eye(world_table(), eye_at(0));
  add_view(memory, 1 * kSecond, good);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float huge = std::numeric_limits<float>::max();
  std::vector<PointCloud> bad(7, taken_from_eye(world_table(), eye_at(90)).cloud);
  bad[0].viewpoint.setConstant(std::numeric_limits<double>::quiet_NaN());
  bad[1].viewpoint.x() = std::numeric_limits<double>::infinity();
  for (Eigen::Vector3f& p : bad[2].points) p.setConstant(nan);
  bad[3] = {};
  bad[4] = {};
  bad[4].points = {{0.0f, 0.0f, 1.0f}, {nan, 0.0f, 1.0f}};
  for (Eigen::Vector3f& p : bad[5].points) p.setZero();
  for (Eigen::Vector3f& p : bad[6].points) p.setConstant(huge);
  const Eigen::Isometry3d X_WK = world_seen_from(eye_at(90)).inverse();
  std::int64_t utime = 2 * kSecond;
  for (std::size_t n = 0; n < bad.size(); ++n) {
    CAPTURE(n);
    CHECK(memory.add(++utime, bad[n], X_WK).matrix().isIdentity(0.0));
    CHECK(memory.size() == 1);
  }
  REQUIRE(memory.others(utime, X_WK).size() == 1);
  // A good cloud after them is.
  memory.add(++utime, taken_from_eye(world_table(), eye_at(90)).cloud, X_WK);
  CHECK(memory.size() == 2);
}

TEST_CASE("a memory with options out of range is refused", "[views][memory]") {
  DetectorOptions options;
  options.views.most = 0;
  CHECK(error_of([&] { ViewMemory memory(options); }).find("views.most") != std::string::npos);
  options.views.most = 8;
  options.views.remember = -1.0;
  CHECK(error_of([&] { ViewMemory memory(options); }).find("views.remember") != std::string::npos);
  options.views.remember = 60.0;
  options.views.sector = 0.0;
  CHECK(error_of([&] { ViewMemory memory(options); }).find("views.sector") != std::string::npos);
}

TEST_CASE("a camera beside another one shows its side too, whichever comes first",
          "[views][memory]") {
  const double apart = GENERATE(5.0, 10.0);
  const bool first = GENERATE(true, false);
  const Taken one = taken_from_eye(world_table(), eye_at(0));
  const Taken other = taken_from_eye(world_table(), eye_at(apart));
  ViewMemory memory;
  for (int n = 1; n <= 3; ++n) {
    memory.add(n * kSecond + (first ? 0 : 1000), one.cloud, one.X_WK, 0);
    memory.add(n * kSecond + (first ? 1000 : 0), other.cloud, other.X_WK, 1);
    CHECK(memory.size() == 2);
  }
  CHECK(memory.others(3 * kSecond + (first ? 0 : 1000), one.X_WK, 0).size() == 1);
}

TEST_CASE("a cloud that comes late from another camera brings back nothing that has gone",
          "[views][memory]") {
  const auto ball_points = [](const ViewMemory& memory) {
    int count = 0;
    for (const PointCloud& view : views_in_world(memory)) {
      for (const Eigen::Vector3f& p : view.points) {
        const double distance = (p.cast<double>() - Eigen::Vector3d(-0.2, 0.0, kBall)).norm();
        count += p.allFinite() && p.z() > 0.01f && std::abs(distance - kBall) < 0.006;
      }
    }
    return count;
  };
  const Taken with_ball = taken_from_eye(world_table(), eye_at(60));
  const Taken without = taken_from_eye(world_without_ball(), eye_at(0));
  ViewMemory memory;
  memory.add(2 * kSecond, without.cloud, without.X_WK, 0);
  const std::vector<PointCloud> before = views_in_world(memory);
  memory.add(1 * kSecond, with_ball.cloud, with_ball.X_WK, 1);
  REQUIRE(memory.size() == 2);
  CHECK(ball_points(memory) < 10);
  // The newer view comes first, and has lost nothing.
  CHECK(same_bits(views_in_world(memory)[0], before[0]));
}

TEST_CASE("views of two cameras count for each other, even of one time", "[views][memory]") {
  const Taken left = taken_from_eye(world_table(), eye_at(-60));
  const Taken right = taken_from_eye(world_table(), eye_at(60));
  ViewMemory memory;
  memory.add(5 * kSecond, left.cloud, left.X_WK, 1);
  // The other camera's clouds are a little older; that is no log that starts anew.
  memory.add(5 * kSecond - 1000, right.cloud, right.X_WK, 2);
  REQUIRE(memory.size() == 2);
  CHECK(memory.others(5 * kSecond, left.X_WK, 1).size() == 1);
  CHECK(memory.others(5 * kSecond - 1000, right.X_WK, 2).size() == 1);
  memory.add(5 * kSecond, right.cloud, right.X_WK, 2);
  REQUIRE(memory.size() == 2);
  CHECK(memory.others(5 * kSecond, right.X_WK, 2).size() == 1);
  // The camera's own time goes back.
  memory.add(1 * kSecond, right.cloud, right.X_WK, 2);
  CHECK(memory.size() == 1);
}
