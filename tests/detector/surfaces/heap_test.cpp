#include "surfaces/heap.hpp"

#include <cmath>
#include <vector>

#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// What is found of the top of a sphere that lies on a table, or this high above it.
/// @param slope  angle at which the sphere meets its base
/// @param width  diameter of the base [m]
DetectionResult cap_on_table(double slope, double width, double above = 0.0) {
  const Eigen::Isometry3d X_CW = world_seen_from({0.0, -0.6, 0.6});
  const double radius = 0.5 * width / std::sin(slope);
  Patch cap = sphere(X_CW * translation(0, 0, above - radius * std::cos(slope)), radius);
  cap.box_B.min().z() = radius * std::cos(slope);
  Camera camera;
  camera.noise = 0.001;
  return detect(render({rectangle(X_CW, 1.2, 0.9), cap}, camera));
}

int count_curved(const DetectionResult& result) {
  int count = 0;
  for (const Detection& d : result.detections) count += !is_flat(d.type);
  return count;
}

int count_lumps(const DetectionResult& result) {
  int count = 0;
  for (const SceneBody& body : result.bodies) count += body.kind == BodyKind::kLump;
  return count;
}

TEST_CASE("what rises from a table no steeper than cloth is a lump", "[surfaces][heap]") {
  const double slope = GENERATE(25.0, 32.0, 39.0);
  CAPTURE(slope);
  const DetectionResult found = cap_on_table(slope * kDegree, 0.2);
  CHECK(count_curved(found) == 0);
  CHECK(count_lumps(found) == 1);
}

TEST_CASE("a dome that meets its table at a steeper angle is a surface", "[surfaces][heap]") {
  const double slope = GENERATE(52.0, 65.0, 90.0);
  CAPTURE(slope);
  CHECK(count_curved(cap_on_table(slope * kDegree, 0.16)) == 1);
}

TEST_CASE("a gentle surface whose foot is above the table is no heap", "[surfaces][heap]") {
  CHECK(count_curved(cap_on_table(32.0 * kDegree, 0.2, 0.05)) == 1);
}

TEST_CASE("the inner side of a shallow bowl is no heap", "[surfaces][heap]") {
  const Eigen::Isometry3d X_CW = world_seen_from({0.0, -0.4, 0.7});
  const double radius = 0.15;
  Patch bowl = sphere(X_CW * translation(0, 0, radius + 0.005), radius);
  bowl.box_B.max().z() = -radius * std::cos(40.0 * kDegree);
  Camera camera;
  camera.noise = 0.001;
  CHECK(count_curved(detect(render({rectangle(X_CW, 1.2, 0.9), bowl}, camera))) == 1);
}

}  // namespace
}  // namespace quadrille::test
