#include "surfaces/lid.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "detector/table_scene.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kLong = 0.045, kShort = 0.025, kHeight = 0.1;
const Eigen::Isometry3d X_CW = world_seen_from({0.0, -0.55, 0.45});

/// The mantle of an elliptic cylinder that stands at the origin of W, turned about its axis.
Patch elliptic_mantle(double turn, double a, double b) {
  Patch patch = mantle(X_CW * translation(0, 0, 0.5 * kHeight) *
                           Eigen::Isometry3d(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ())),
                       1.0, kHeight);
  patch.D = diagonal(1.0 / (a * a), 1.0 / (b * b), 0.0, -1.0);
  return patch;
}

/// Its lid.
Patch elliptic_lid(const Patch& mantle) {
  Patch lid = rectangle(mantle.X_CB * translation(0, 0, 0.5 * kHeight), 1e3, 1e3);
  lid.within = mantle.D;
  return lid;
}

DetectionResult detect_on_table(std::vector<Patch> patches, double noise) {
  patches.push_back(rectangle(X_CW, 1.0, 0.9));
  Camera camera;
  camera.width = 480, camera.height = 360, camera.pitch = 1.0 / 450.0;
  camera.noise = noise;
  return detect(render(patches, camera));
}

/// The upright round or elliptic cylinder near the axis of W.
const Detection* standing(const DetectionResult& result) {
  for (const Detection& d : result.detections) {
    const bool cylinder =
        d.type == QuadricType::kCylinder || d.type == QuadricType::kEllipticCylinder;
    if (cylinder && std::abs(d.X_CQ.linear().col(2).dot(X_CW.linear().col(2))) > 0.95) return &d;
  }
  return nullptr;
}

double deviation_of(const Detection& detection) {
  double largest = 0.0;
  for (const Dimension& d : detection.dimensions) {
    if (d.name != "length") largest = std::max(largest, d.std);
  }
  return largest;
}

}  // namespace

TEST_CASE("a lid shows the section of an elliptic cylinder from every side", "[detector]") {
  for (const double noise : {0.0, 0.001}) {
    for (int k = 0; k < 6; ++k) {
      const Patch wall = elliptic_mantle(k * M_PI / 6.0, kLong, kShort);
      const DetectionResult result = detect_on_table({wall, elliptic_lid(wall)}, noise);
      CAPTURE(noise, k);
      const Detection* const found = standing(result);
      REQUIRE(found);
      REQUIRE(found->type == QuadricType::kEllipticCylinder);
      CHECK(found->dimension(0) == Approx(kLong).margin(0.001));
      CHECK(found->dimension(1) == Approx(kShort).margin(0.001));
      CHECK(deviation_of(*found) < 0.0015);
    }
  }
}

TEST_CASE("a can with a round lid stays round", "[detector]") {
  for (const double radius : {0.02, 0.04}) {
    const Patch wall = elliptic_mantle(0.0, radius, radius);
    const DetectionResult result = detect_on_table({wall, elliptic_lid(wall)}, 0.001);
    const Detection* const found = standing(result);
    CAPTURE(radius);
    REQUIRE(found);
    CHECK(found->type == QuadricType::kCylinder);
    CHECK(found->dimension(0) == Approx(radius).margin(0.0005));
  }
}

TEST_CASE("half of a lid shows the section", "[detector]") {
  const Patch wall = elliptic_mantle(0.0, kLong, kShort);
  // A post before the body hides a side of the wall and of the lid.
  const auto post = box(X_CW * translation(-0.045, -0.12, 0.1), {0.03, 0.03, 0.2});
  std::vector<Patch> patches = {wall, elliptic_lid(wall)};
  patches.insert(patches.end(), post.begin(), post.end());
  const DetectionResult result = detect_on_table(patches, 0.0005);
  const Detection* const found = standing(result);
  REQUIRE(found);
  REQUIRE(found->type == QuadricType::kEllipticCylinder);
  CHECK(found->dimension(0) == Approx(kLong).margin(0.002));
  CHECK(found->dimension(1) == Approx(kShort).margin(0.002));
}

TEST_CASE("neither an open end nor a plate on it changes a can", "[detector]") {
  constexpr double kRadius = 0.035;
  const Patch wall = elliptic_mantle(0.0, kRadius, kRadius);
  const DetectionResult open = detect_on_table({wall}, 0.0005);
  // The plate is that of another body, and lies where a lid would.
  Patch plate = rectangle(wall.X_CB * translation(0.02, 0.03, 0.5 * kHeight), 0.14, 0.12);
  const DetectionResult covered = detect_on_table({wall, plate}, 0.0005);
  for (const DetectionResult* result : {&open, &covered}) {
    const Detection* const found = standing(*result);
    REQUIRE(found);
    CHECK(found->type == QuadricType::kCylinder);
    CHECK(found->dimension(0) == Approx(kRadius).margin(0.001));
  }
}
