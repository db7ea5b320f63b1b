#include "bodies/close_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

using test::Patch;

constexpr double kWallRadius = 0.036, kWallLength = 0.11, kNeckRadius = 0.014;

/// Pose of a bottle's foot on a table that a camera sees from the front.
const Eigen::Isometry3d& bottle_foot() {
  static const Eigen::Isometry3d X_CF = test::world_seen_from({0.0, -0.6, 0.35});
  return X_CF;
}

/// The shoulder from the wall to the neck.
Patch shoulder(double length) {
  const double slope = (kWallRadius - kNeckRadius) / length, below = kWallRadius / slope;
  Patch patch;
  patch.D = test::diagonal(1.0, 1.0, -slope * slope, 0.0);
  patch.X_CB = bottle_foot() * test::translation(0.0, 0.0, kWallLength + below);
  patch.box_B.min().z() = -below;
  patch.box_B.max().z() = length - below;
  return patch;
}

Patch bottle_wall() {
  return test::mantle(bottle_foot() * test::translation(0.0, 0.0, 0.5 * kWallLength), kWallRadius,
                      kWallLength);
}

/// The widest cylinder that is found of these patches on a table.
Detection widest_cylinder(std::vector<Patch> patches) {
  patches.push_back(test::rectangle(bottle_foot(), 1.4, 1.2));
  const DetectionResult result = detect(test::render(patches, {640, 480, 1.0 / 600.0, 0.0008, 3}));
  const Detection* widest = nullptr;
  for (const Detection& d : result.detections) {
    if (d.type != QuadricType::kCylinder) continue;
    if (widest == nullptr || d.dimension(0) > widest->dimension(0)) widest = &d;
  }
  REQUIRE(widest);
  return *widest;
}

TEST_CASE("the wall of a bottle ends where the shoulder begins", "[bodies]") {
  for (const double length : {0.035, 0.05}) {
    const Detection closed = widest_cylinder({bottle_wall(), shoulder(length)});
    CHECK(closed.dimension(1) == Approx(kWallLength).margin(0.003));
    CHECK(closed.dimensions[1].std > 0.0);
    CHECK(closed.dimensions[1].std < 0.004);
    CHECK(std::abs(closed.dimension(1) - kWallLength) < 3.0 * closed.dimensions[1].std);
  }
}

TEST_CASE("a wall alone is as long as its samples tell", "[bodies]") {
  const Detection open = widest_cylinder({bottle_wall()});
  CHECK(open.dimension(1) > open.extent_Q.sizes().z());
  CHECK(open.dimension(1) == Approx(kWallLength).margin(0.008));
}

}  // namespace
}  // namespace quadrille
