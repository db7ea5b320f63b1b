#include "samples/depth/cell_sums.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

constexpr int kColumns = 50, kRows = 20;
constexpr float kPitch = 0.002f;

/// A wavy surface seen pixel by pixel, row by row.
/// @param missing  share of the pixels without a point
/// @param organised  if true, missing points are NaN; otherwise they are left out
PointCloud wavy_image(double missing, bool organised) {
  PointCloud cloud;
  RandomStream random(11, organised);
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const float z = 1.0f + 0.05f * std::sin(0.3f * static_cast<float>(i + 2 * j));
      const Eigen::Vector3f ray((static_cast<float>(i) + 0.5f) * kPitch,
                                (static_cast<float>(j) + 0.5f) * kPitch, 1.0f);
      if (random.uniform() >= missing) {
        cloud.points.push_back(z * ray);
      } else if (organised) {
        cloud.points.push_back(Eigen::Vector3f::Constant(NAN));
      }
    }
  }
  return cloud;
}

/// Compares the sums over cells of some pixels with those of one point after the other.
void check_sums(const PointCloud& cloud, int pixels) {
  const PinholeView view;
  const int width = (kColumns + pixels - 1) / pixels, height = (kRows + pixels - 1) / pixels;
  const CellGrid grid{0.0f, 0.0f, 1.0f / (kPitch * static_cast<float>(pixels)), width, height};
  const std::size_t cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  CellSums sums(cells), expected(cells);
  std::vector<int> of_point(cloud.points.size() + SeenPoints::kSize);
  add_points(cloud, view, grid, of_point.data(), &sums);
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    const Eigen::Vector3f t = view(cloud.points[k]);
    if (!(t.z() > 0.0f)) {
      CHECK(of_point[k] == -1);
      continue;
    }
    const int c =
        static_cast<int>(t.y() * grid.per_unit) * width + static_cast<int>(t.x() * grid.per_unit);
    REQUIRE(of_point[k] == c);
    expected.n[c] += 1.0f, expected.u[c] += t.x(), expected.v[c] += t.y(), expected.w[c] += t.z();
    expected.min_w[c] = std::min(expected.min_w[c], t.z());
    expected.max_w[c] = std::max(expected.max_w[c], t.z());
  }
  CHECK(sums.n == expected.n);
  CHECK(sums.min_w == expected.min_w);
  CHECK(sums.max_w == expected.max_w);
  for (std::size_t c = 0; c < cells; ++c) {
    REQUIRE(sums.u[c] == Approx(expected.u[c]).epsilon(1e-5));
    REQUIRE(sums.v[c] == Approx(expected.v[c]).epsilon(1e-5));
    REQUIRE(sums.w[c] == Approx(expected.w[c]).epsilon(1e-5));
  }
}

}  // namespace

TEST_CASE(
    "the sums over a cell are those of its points, however many pixels it has and wherever "
    "points are missing",
    "[depth][cells]") {
  for (const int pixels : {1, 2, 3, 5}) {
    for (const double missing : {0.0, 0.01, 0.3}) {
      for (const bool organised : {false, true}) {
        CAPTURE(pixels, missing, organised);
        check_sums(wavy_image(missing, organised), pixels);
      }
    }
  }
}
