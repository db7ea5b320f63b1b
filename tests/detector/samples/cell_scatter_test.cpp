#include "samples/cell_scatter.hpp"

#include <memory>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE(
    "points spread over a cell as over a square, and cells that are not asked for are left out",
    "[samples]") {
  // A wall 1 m ahead: pixels of 2 mm and cells of 4 pixels.
  Camera camera;
  camera.pitch = 1.0 / 500.0;
  const PointCloud cloud = render({rectangle(translation(0, 0, 1), 10, 10)}, camera);
  SamplingOptions options;
  options.cell = 0.008;
  const std::unique_ptr<CellPyramid> pyramid = make_pyramid(cloud, options);
  REQUIRE(pyramid);
  std::vector<int> number(static_cast<std::size_t>(pyramid->size(0)), -1);
  Eigen::Matrix3f mean = Eigen::Matrix3f::Zero();
  float owned = 0;
  for (std::size_t c = 0; c < number.size(); c += 2) number[c] = static_cast<int>(c);
  std::vector<Eigen::Matrix3f> scatter(number.size(), Eigen::Matrix3f::Zero());
  scatter_in_cells(cloud, *pyramid, number, &scatter);
  for (std::size_t c = 0; c < number.size(); ++c) {
    if (number[c] < 0) {
      CHECK(scatter[c].isZero(0.0f));
    } else if (pyramid->count(static_cast<int>(c)) == 16) {
      mean += scatter[c];
      ++owned;
    }
  }
  REQUIRE(owned > 1000);
  mean /= owned;
  // Four pixels at distances of 2 mm have the variance 4 mm² (4² - 1) / 12.
  CHECK(mean(0, 0) == Approx(5e-6).epsilon(0.05));
  CHECK(mean(1, 1) == Approx(5e-6).epsilon(0.05));
  CHECK(std::abs(mean(0, 1)) < 5e-7);
  CHECK(std::abs(mean(2, 2)) < 1e-8);
}
