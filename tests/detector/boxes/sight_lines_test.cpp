#include "boxes/sight_lines.hpp"

#include <cmath>

#include "support/catch.hpp"

namespace quadrille {
namespace {

const Eigen::AlignedBox3d kUnit(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());

/// A wall of points at z = 2 behind the unit box, seen from z = −1 over its middle.
PointCloud wall() {
  PointCloud cloud;
  cloud.viewpoint = {0.5, 0.5, -1.0};
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) cloud.points.emplace_back(0.1f * i - 2.5f, 0.1f * j - 2.5f, 2.0f);
  }
  return cloud;
}

std::vector<Eigen::Vector3d> points_of(const PointCloud& cloud) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& p : cloud.points) points.push_back(p.cast<double>());
  return points;
}

TEST_CASE("a segment is clipped by a box", "[boxes][sight]") {
  const auto through = clip(kUnit, {-1.0, 0.5, 0.5}, {3.0, 0.5, 0.5});
  REQUIRE(through);
  CHECK(through->first == Approx(0.25));
  CHECK(through->second == Approx(0.5));
  const auto into = clip(kUnit, {-1.0, 0.5, 0.5}, {0.5, 0.5, 0.5});
  REQUIRE(into);
  CHECK(into->second == Approx(1.0));
  CHECK_FALSE(clip(kUnit, {-1.0, 0.5, 0.5}, {-0.1, 0.5, 0.5}));
  CHECK_FALSE(clip(kUnit, {-1.0, 2.0, 0.5}, {3.0, 2.0, 0.5}));
  CHECK_FALSE(clip(kUnit, {-1.0, 0.5, 0.5}, {0.5, 3.0, 0.5}));
}

TEST_CASE("points behind a box were seen through it", "[boxes][sight]") {
  const PointCloud cloud = wall();
  const DirectionIndex sight(cloud);
  REQUIRE(sight.single());
  // The box spans tangents of ±1/2 at its front, which is ±3/2 on the wall: 30 points a side.
  const int count =
      count_seen_within(kUnit, Eigen::Isometry3d::Identity(), points_of(cloud), sight);
  CHECK(count > 28 * 28);
  CHECK(count < 32 * 32);
}

TEST_CASE("an end may be moved up to the first line of sight beside it", "[boxes][sight]") {
  const PointCloud cloud = wall();
  const DirectionIndex sight(cloud);
  std::vector<Eigen::Vector3d> beside;
  for (const Eigen::Vector3d& p : points_of(cloud)) {
    if (p.x() > 2.55) beside.push_back(p);
  }
  // The line to x = 2.6 passes the far side of the box, z = 1, at x = 0.5 + 2.1 · 2/3.
  const double free = free_of_sight(kUnit, Eigen::Isometry3d::Identity(), 0, 1, beside, sight, 0);
  CHECK(free == Approx(0.5 + 2.1 * 1.0 / 3.0 - 1.0).margin(1e-5));
  CHECK(std::isinf(free_of_sight(kUnit, Eigen::Isometry3d::Identity(), 0, -1, beside, sight, 0)));
}

}  // namespace
}  // namespace quadrille
