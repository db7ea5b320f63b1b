#include "bodies/walls.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

using test::Patch;

// A thinner wall is within the noise of this camera, so that its thickness is not told [m].
constexpr double kThick = 0.008;

/// A camera looks down into what stands in the middle of a table.
const Eigen::Isometry3d& table_below() {
  static const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.45, 0.5});
  return X_CW;
}

DetectionResult seen_on_table(std::vector<Patch> patches, std::uint64_t seed = 1) {
  patches.push_back(test::rectangle(table_below(), 1.4, 1.2));
  return detect(test::render(patches, {640, 480, 1.0 / 600.0, 0.0005, seed}));
}

/// A wall about the middle of the table from the height 0 to another one.
Patch upright(double radius, double height) {
  return test::mantle(table_below() * test::translation(0.0, 0.0, 0.5 * height), radius, height);
}

/// A wall that widens upward from radius r0 to r1, between two heights.
Patch tapered(double r0, double r1, double height) {
  const double slope = (r1 - r0) / height, below = r0 / slope;
  Patch patch;
  patch.D = test::diagonal(1.0, 1.0, -slope * slope, 0.0);
  patch.X_CB = table_below() * test::translation(0.0, 0.0, -below);
  patch.box_B.min().z() = below;
  patch.box_B.max().z() = below + height;
  return patch;
}

/// The lower part of a sphere that touches the table, up to a height.
Patch bowl(double radius, double centre, double height) {
  Patch patch = test::sphere(table_below() * test::translation(0.0, 0.0, centre), radius);
  patch.box_B.max().z() = height - centre;
  return patch;
}

const SceneBody* revolved_body(const DetectionResult& result) {
  const auto found =
      std::find_if(result.bodies.begin(), result.bodies.end(),
                   [](const SceneBody& body) { return body.kind == BodyKind::kRevolution; });
  return found == result.bodies.end() ? nullptr : &*found;
}

void check_wall(const SceneBody* body, double thickness) {
  REQUIRE(body);
  REQUIRE(body->wall);
  CHECK(body->wall->std > 0.0);
  CHECK(body->wall->std < 0.002);
  CHECK(body->wall->thickness == Approx(thickness).margin(std::max(3.0 * body->wall->std, 0.001)));
}

/// The types of a body's curved parts.
std::vector<QuadricType> types_of(const DetectionResult& result, const SceneBody& body) {
  std::vector<QuadricType> types;
  for (const Detection& d : result.detections) {
    if (std::count(body.parts.begin(), body.parts.end(), d.id) == 0) continue;
    if (d.type != QuadricType::kPlane) types.push_back(d.type);
  }
  return types;
}

TEST_CASE("the two sides of a mug tell how thick its wall is", "[bodies]") {
  const double radius = 0.05, height = 0.09;
  const DetectionResult result =
      seen_on_table({upright(radius, height), upright(radius - kThick, height)});
  const SceneBody* mug = revolved_body(result);
  check_wall(mug, kThick);
  CHECK(types_of(result, *mug) == std::vector(2, QuadricType::kCylinder));
}

TEST_CASE("a wall between a round outside and a straight inside is as thick in any frame",
          "[bodies]") {
  const double outer = 0.06, inner = 0.048, height = 0.09;
  std::vector<Patch> patches = {bowl(outer, 0.045, height), upright(inner, height)};
  patches.push_back(test::rectangle(table_below(), 1.4, 1.2));
  const PointCloud cloud = test::render(patches, {640, 480, 1.0 / 600.0, 0.0005, 1});
  std::vector<double> thickness;
  for (const Eigen::Vector3d& turn :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1.2, 0, 0), Eigen::Vector3d(0.3, -1.5, 0.4)}) {
    Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
    if (!turn.isZero()) X_FC.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).matrix();
    const DetectionResult result = detect(moved(cloud, X_FC));
    const SceneBody* pot = revolved_body(result);
    if (pot && pot->wall) thickness.push_back(pot->wall->thickness);
  }
  REQUIRE(thickness.size() >= 2);
  const auto [low, high] = std::minmax_element(thickness.begin(), thickness.end());
  CHECK(*high - *low < 0.0005);
  CHECK(*high < outer - inner);
}

TEST_CASE("the two sides of a tapered cup are cones with a wall between them", "[bodies]") {
  const double low = 0.035, high = 0.05, height = 0.09;
  const DetectionResult result =
      seen_on_table({tapered(low, high, height), tapered(low - kThick, high - kThick, height)});
  const SceneBody* cup = revolved_body(result);
  check_wall(cup, kThick * std::cos(std::atan((high - low) / height)));
  CHECK(types_of(result, *cup) == std::vector(2, QuadricType::kCone));
}

TEST_CASE("the two spheres of a bowl are one body with a wall", "[bodies]") {
  const double radius = 0.07, height = 0.085;
  const DetectionResult result =
      seen_on_table({bowl(radius, radius, height), bowl(radius - kThick, radius, height)});
  const SceneBody* found = revolved_body(result);
  check_wall(found, kThick);
  CHECK(types_of(result, *found) == std::vector(2, QuadricType::kSphere));
}

TEST_CASE("cans and shells without thickness have no wall", "[bodies]") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::vector<Patch> can =
        test::can(table_below() * test::translation(0.0, 0.0, 0.05), 0.04, 0.1);
    for (const auto& patches : {can, {upright(0.05, 0.09)}, {bowl(0.09, 0.09, 0.075)}}) {
      for (const SceneBody& body : seen_on_table(patches, seed).bodies) CHECK_FALSE(body.wall);
    }
  }
}

}  // namespace
}  // namespace quadrille
