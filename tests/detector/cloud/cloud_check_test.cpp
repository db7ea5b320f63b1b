#include "cloud/cloud_check.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

PointCloud box_of_points(double size, int count) {
  PointCloud cloud;
  RandomStream random(111, 0);
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    cloud.points.push_back((size * Eigen::Vector3d(x, y, z + 0.5)).cast<float>());
  }
  return cloud;
}

bool warns(const CloudCheck& check, const std::string& text) {
  for (const std::string& warning : check.warnings) {
    if (warning.find(text) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a cloud in metres is usable without a warning", "[check]") {
  const CloudCheck check = check_cloud(box_of_points(1.0, 1000));
  CHECK(check.range.near == 1000);
  CHECK(check.usable);
  CHECK(check.warnings.empty());
}

TEST_CASE("points that are not finite are not counted", "[check][hostile]") {
  PointCloud cloud = box_of_points(1.0, 1000);
  for (std::size_t i = 0; i < 300; ++i) cloud.points[i].x() = NAN;
  cloud.points[300].z() = std::numeric_limits<float>::infinity();
  CHECK(check_cloud(cloud).range.near == 699);
  CHECK(check_cloud(cloud).usable);
}

TEST_CASE("too few points are refused with their number", "[check][degenerate]") {
  for (const int count : {0, 1, 49}) {
    const CloudCheck check = check_cloud(box_of_points(1.0, count));
    CHECK_FALSE(check.usable);
    CHECK(warns(check, "only " + std::to_string(count) + " finite points"));
  }
  CHECK(check_cloud(box_of_points(1.0, 50)).usable);
}

TEST_CASE("a far cloud without its viewpoint is no cloud in millimetres", "[check]") {
  PointCloud cloud = box_of_points(1.0, 1000);
  for (Eigen::Vector3f& p : cloud.points) p.x() += 1000.0f;
  CHECK(check_cloud(cloud).centre.x() == Approx(1000.5).epsilon(1e-4));
  CHECK(warns(check_cloud(cloud), "name the sensor's position"));
  CHECK_FALSE(warns(check_cloud(cloud), "millimetres"));
  cloud.viewpoint.x() = 1000.0;
  CHECK(check_cloud(cloud).warnings.empty());
}

TEST_CASE("outliers neither hide a cloud nor make a line of it", "[check][hostile]") {
  PointCloud cloud = box_of_points(1.0, 1000);
  for (const float far : {1e4f, 1e20f, 3e38f}) {
    cloud.points[500] = Eigen::Vector3f::Constant(far);
    CHECK(check_cloud(cloud).usable);
    CHECK(check_cloud(cloud).warnings == std::vector{check_range(cloud).warning()});
  }
}

TEST_CASE("copies of one point, however many, do not hide the others", "[check][hostile]") {
  for (const double share : {0.6, 0.95, 0.99}) {
    for (const float size : {0.0f, 0.001f}) {
      PointCloud cloud = box_of_points(1.0, 5000);
      const auto copies = static_cast<std::size_t>(share * 5000.0);
      for (std::size_t i = 0; i < copies; ++i) {
        cloud.points[i] = {0.2f, 0.1f, 0.7f + size * static_cast<float>(i % 7)};
      }
      CAPTURE(share, size);
      CHECK(check_cloud(cloud).usable);
      CHECK(check_cloud(cloud).warnings.empty());
    }
  }
}

TEST_CASE("coordinates too large for single precision are noticed", "[check]") {
  PointCloud cloud = box_of_points(1.0, 1000);
  for (Eigen::Vector3f& p : cloud.points) p += Eigen::Vector3f(5e5f, 5.4e6f, 100.0f);
  cloud.viewpoint = {5e5, 5.4e6, 100.0};
  CHECK(warns(check_cloud(cloud), "subtract an offset"));
}

TEST_CASE("millimetres are noticed, but looked at", "[check]") {
  const CloudCheck check = check_cloud(box_of_points(1000.0, 1000));
  CHECK(check.usable);
  CHECK(warns(check, "millimetres"));
}

TEST_CASE("metres that were read as millimetres are noticed wherever the viewpoint is", "[check]") {
  PointCloud cloud = box_of_points(1e-3, 1000);
  cloud.viewpoint = {0.5, 0.1, 0.6};
  const CloudCheck check = check_cloud(cloud);
  CHECK(check.usable);
  CHECK(warns(check, "do not read them as millimetres (--unit mm)"));
  // Seen from their middle, they are refused with their viewpoint.
  cloud.viewpoint.setZero();
  CHECK(check_cloud(cloud).warnings.empty());
  CHECK(contradict_viewpoint(cloud, {}).find("as millimetres (--unit mm)") != std::string::npos);
  // A small thing before a camera is no mistake.
  PointCloud small = box_of_points(0.02, 1000);
  small.viewpoint.z() = -0.3;
  CHECK(check_cloud(small).warnings.empty());
}

TEST_CASE("coincident points, lines and absurd numbers are refused", "[check][degenerate]") {
  PointCloud cloud = box_of_points(1.0, 1000);
  for (Eigen::Vector3f& p : cloud.points) p = {0.3f, 0.1f, 1.0f};
  CHECK(warns(check_cloud(cloud), "coincide"));
  CHECK_FALSE(check_cloud(cloud).usable);
  RandomStream random(112, 0);
  for (Eigen::Vector3f& p : cloud.points) {
    const double t = random.uniform();
    p = Eigen::Vector3f(0.3f, 0.1f, 1.0f) + static_cast<float>(t) * Eigen::Vector3f(1, 2, 3);
  }
  CHECK(warns(check_cloud(cloud), "line"));
  CHECK_FALSE(check_cloud(cloud).usable);
  const CloudCheck absurd = check_cloud(box_of_points(1e20, 1000));
  CHECK(warns(absurd, "too large"));
  CHECK_FALSE(absurd.usable);
}
