#include "base/cloud_runs.hpp"

#include <limits>
#include <random>

#include "support/catch.hpp"

namespace quadrille {
namespace {

/// A thousand points, each a small step from the one before.
PointCloud wandering_points(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> step(-0.01f, 0.01f);
  PointCloud cloud;
  Eigen::Vector3f p(0.0f, 0.0f, 0.5f);
  for (int n = 0; n < 1000; ++n) {
    p += Eigen::Vector3f(step(random), step(random), step(random));
    cloud.points.push_back(p);
  }
  return cloud;
}

}  // namespace

TEST_CASE("all points in a box are found in order, missing ones never", "[cloud_runs]") {
  PointCloud cloud = wandering_points(5);
  for (int n = 0; n < 1000; n += 7) {
    cloud.points[n].y() = std::numeric_limits<float>::quiet_NaN();
  }
  // A whole run without a point.
  for (int n = 320; n < 400; ++n) {
    cloud.points[n] = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  }
  const CloudRuns runs(cloud);
  for (const float half : {0.0f, 0.01f, 0.05f, 10.0f}) {
    const Eigen::Vector3f middle = cloud.points[501], reach = Eigen::Vector3f::Constant(half);
    const Eigen::AlignedBox3f box(middle - reach, middle + reach);
    std::vector<std::size_t> expected, found;
    for (std::size_t n = 0; n < cloud.points.size(); ++n) {
      if (cloud.points[n].allFinite() && box.contains(cloud.points[n])) expected.push_back(n);
    }
    runs.each_in(box, [&](std::size_t n) { found.push_back(n); });
    CHECK(found == expected);
    CHECK(!found.empty());
    CHECK(runs.count_near(box) >= found.size());
  }
  const Eigen::Vector3f far = Eigen::Vector3f::Constant(100.0f);
  CHECK(runs.count_near({far, far}) == 0);
  CloudRuns().each_in({far, far}, [](std::size_t) { FAIL("there are no points"); });
}

TEST_CASE("all points in any of several boxes are found in order, each once", "[cloud_runs]") {
  const PointCloud cloud = wandering_points(6);
  const CloudRuns runs(cloud);
  for (const float half : {0.0f, 0.01f, 0.05f, 10.0f}) {
    std::vector<Eigen::AlignedBox3f> boxes;
    for (const int n : {100, 130, 700}) {
      const Eigen::Vector3f middle = cloud.points[n], reach = Eigen::Vector3f::Constant(half);
      boxes.emplace_back(middle - reach, middle + reach);
    }
    std::vector<std::size_t> expected, found;
    for (std::size_t n = 0; n < cloud.points.size(); ++n) {
      bool inside = false;
      for (const Eigen::AlignedBox3f& box : boxes) inside |= box.contains(cloud.points[n]);
      if (inside) expected.push_back(n);
    }
    runs.each_in_any(boxes, [&](std::size_t n) { found.push_back(n); });
    CHECK(found == expected);
    CHECK(found.size() >= 3);
  }
  runs.each_in_any({}, [](std::size_t) { FAIL("there is no box"); });
}

}  // namespace quadrille
