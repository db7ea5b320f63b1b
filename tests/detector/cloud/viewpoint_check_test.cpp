#include <cmath>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using test::Camera;
using test::translation;

namespace {

const Eigen::Isometry3d& X_CW() {
  static const Eigen::Isometry3d X = test::world_seen_from({0.6, 0.1, 0.6});
  return X;
}

/// A can and a ball on a table with its surface at z = 0 of W, which is small enough that the
/// camera sees past it.
PointCloud table_scene() {
  std::vector<test::Patch> patches = test::can(X_CW() * translation(0, 0, 0.06), 0.03, 0.12);
  patches.push_back(test::sphere(X_CW() * translation(0.05, 0.15, 0.04), 0.04));
  patches.push_back(test::rectangle(X_CW(), 0.8, 0.8));
  Camera camera;
  camera.noise = 0.0005;
  return test::render(patches, camera);
}

/// What is wrong with a viewpoint p_WE of the scene.
std::string doubt_at(PointCloud cloud, const Eigen::Vector3d& p_WE) {
  const std::vector<Detection> detections = detect(cloud).detections;
  cloud.viewpoint = X_CW() * p_WE;
  return contradict_viewpoint(cloud, detections);
}

PointCloud unorganised(PointCloud cloud) {
  std::erase_if(cloud.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  cloud.width = cloud.height = 0;
  return cloud;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("nothing speaks against where a camera stood, in whatever frame", "[viewpoint]") {
  const PointCloud cloud = table_scene();
  CHECK(detect(cloud).warnings.empty());
  const Eigen::Isometry3d X_FC =
      Eigen::Translation3d(1, 2, 3) * Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  CHECK(detect(moved(cloud, X_FC)).warnings.empty());
  CHECK(detect(unorganised(cloud)).warnings.empty());
}

TEST_CASE("a viewpoint below the table that things stand on is told from one above",
          "[viewpoint]") {
  const PointCloud cloud = unorganised(table_scene());
  for (const double x : {-0.3, 0.0, 0.3}) {
    const std::string below = doubt_at(cloud, {x, 0.0, -0.2});
    CAPTURE(x, below);
    CHECK(has(below, "lie hidden behind it"));
    CHECK(has(below, "plane 0.20 m away"));
    CHECK(has(below, "--viewpoint"));
    CHECK(below.find('\n') == std::string::npos);
    CHECK(doubt_at(cloud, {x, 0.0, 0.5}).empty());
  }
}

TEST_CASE("a viewpoint among the points, on one of them or nowhere is no viewpoint",
          "[viewpoint]") {
  PointCloud ball;
  ball.viewpoint = {0, 0, 1};
  for (int i = 0; i < 3000; ++i) {
    const double z = 1.0 - (i + 0.5) / 1500.0, r = std::sqrt(1.0 - z * z);
    ball.points.push_back(
        (0.05 * Eigen::Vector3d(r * std::cos(2.4 * i), r * std::sin(2.4 * i), z)).cast<float>());
  }
  // Seen from all sides, as no single view is: no fault of its viewpoint.
  CHECK(contradict_viewpoint(ball, {}).empty());
  ball.viewpoint.setZero();
  CHECK(has(contradict_viewpoint(ball, {}), "points lie on all sides"));
  ball.viewpoint = {0.05, 0, 0};
  CHECK(has(contradict_viewpoint(ball, {}), "within 20 mm"));
  CHECK_FALSE(has(contradict_viewpoint(ball, {}), "--unit"));
  ball.viewpoint.setConstant(std::nan(""));
  CHECK(has(contradict_viewpoint(ball, {}), "is not known"));
  ball.points.resize(3);
  ball.viewpoint.setZero();
  CHECK(contradict_viewpoint(ball, {}).empty());
}

TEST_CASE("an image from a lens that sees far to the side is whole", "[viewpoint]") {
  // A wall a metre ahead, 63° to either side, and a smaller one before it.
  PointCloud cloud;
  cloud.width = 640;
  cloud.height = 480;
  for (int row = 0; row < 480; ++row) {
    for (int column = 0; column < 640; ++column) {
      const float u = 1.95f * (static_cast<float>(column) - 319.5f) / 320.0f;
      const float v = 1.46f * (static_cast<float>(row) - 239.5f) / 240.0f;
      const float z = std::abs(u) < 0.3f && std::abs(v) < 0.3f ? 0.6f : 1.0f;
      cloud.points.emplace_back(u * z, v * z, z);
    }
  }
  CHECK(contradict_viewpoint(cloud, {}).empty());
}

TEST_CASE("an image seen from elsewhere is torn at the edges of things", "[viewpoint]") {
  const PointCloud cloud = table_scene();
  REQUIRE(cloud.organised());
  CHECK(doubt_at(cloud, X_CW().inverse() * Eigen::Vector3d(0.02, 0, 0)).empty());
  CHECK_FALSE(doubt_at(cloud, {0.0, 0.0, 0.3}).empty());
}

TEST_CASE("a plane that claims to be huge takes no memory", "[viewpoint][hostile]") {
  const PointCloud cloud = table_scene();
  Detection plane;
  plane.type = QuadricType::kPlane;
  for (const double size : {1e4, 1e30}) {
    plane.extent_Q =
        Eigen::AlignedBox3d(Eigen::Vector3d(-size, -size, 0.0), Eigen::Vector3d(size, size, 0.0));
    CHECK(contradict_viewpoint(cloud, {plane}).empty());
  }
}
