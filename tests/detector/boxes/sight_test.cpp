#include <algorithm>
#include <array>
#include <cmath>

#include "boxes/direction_index.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

constexpr float kPitch = 0.002f;

/// A wall of 400 x 300 pixels, a metre before the eye.
PointCloud image_wall() {
  PointCloud cloud;
  for (int j = 0; j < 300; ++j) {
    for (int i = 0; i < 400; ++i) {
      cloud.points.emplace_back(kPitch * (i - 200), kPitch * (j - 150), 1.0f);
    }
  }
  return cloud;
}

std::vector<Eigen::Vector3d> within(std::vector<Eigen::Vector3d> points, double half) {
  std::erase_if(points,
                [&](const Eigen::Vector3d& p) { return p.head<2>().cwiseAbs().maxCoeff() > half; });
  return points;
}

std::vector<Eigen::Vector3d> square(double half) {
  return {{-half, -half, 1.0}, {half, -half, 1.0}, {-half, half, 1.0}, {half, half, 1.0}};
}

}  // namespace

TEST_CASE("towards a small place all points come", "[boxes][sight]") {
  const PointCloud cloud = image_wall();
  const DirectionIndex sight(cloud);
  // 41 pixels along either side.
  CHECK(within(sight.points_towards(square(0.0401), 0.0), 0.0401).size() == 41 * 41);
}

TEST_CASE("towards a large place fewer points come, evenly spread", "[boxes][sight]") {
  const PointCloud cloud = image_wall();
  const DirectionIndex sight(cloud);
  const auto points = within(sight.points_towards(square(0.2), 0.0), 0.2);
  const double all = std::pow(0.4 / kPitch, 2);
  CHECK(points.size() < 0.3 * all);
  CHECK(points.size() > 0.2 * all);
  // Of each centimetre there are as many, to within what cells of two pixels do.
  std::array<int, 40 * 40> count{};
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Array2i at = ((p.head<2>().array() + 0.2) / 0.01).cast<int>().min(39);
    ++count[at.y() * 40 + at.x()];
  }
  CHECK(*std::min_element(count.begin(), count.end()) >= 3);
  CHECK(*std::max_element(count.begin(), count.end()) <= 12);
}

TEST_CASE("no more points come than are asked for", "[boxes][sight]") {
  const PointCloud cloud = image_wall();
  const DirectionIndex sight(cloud);
  const std::size_t all = sight.points_towards(square(0.08), 0.0).size();
  for (const std::size_t most : {4000, 1000, 100}) {
    const std::size_t count = sight.points_towards(square(0.08), 0.0, most).size();
    CHECK(count <= most * 12 / 10);
    CHECK(count >= std::min(all, most / 5));
  }
}

TEST_CASE("an image that is a single line can be indexed", "[boxes][sight]") {
  PointCloud cloud = image_wall();
  for (Eigen::Vector3f& p : cloud.points) p.y() = 0.0f;
  const DirectionIndex sight(cloud);
  REQUIRE(sight.single());
  CHECK(!sight.points_towards(square(0.1), 0.0).empty());
}

}  // namespace quadrille
