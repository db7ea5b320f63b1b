#include <cmath>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"
#include "view/depth_view.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kPixelsAtMost = 8e6;

// Rows of points whose steps along x are tiny, but for the last one, at x = 1.
PointCloud rows_of_tiny_steps(float step) {
  PointCloud cloud;
  for (int row = 0; row < 20; ++row) {
    for (int n = 0; n < 62; ++n) cloud.points.emplace_back(n * step, 0.05F * row, 1.0F);
    cloud.points.emplace_back(1.0F, 0.05F * row, 1.0F);
  }
  return cloud;
}

double pixels(const DepthView& view) { return static_cast<double>(view.width()) * view.height(); }

}  // namespace

TEST_CASE("points in tiny steps do not make an image of more pixels than any camera's",
          "[occupancy][hostile]") {
  for (const int exponent : {-10, -24, -40, -60, -100, -126, -140, -149}) {
    for (const bool turned : {false, true}) {
      PointCloud cloud = rows_of_tiny_steps(std::ldexp(1.0F, exponent));
      if (turned) {
        for (Eigen::Vector3f& p : cloud.points) std::swap(p.x(), p.y());
      }
      const DepthView view(cloud);
      CAPTURE(exponent, turned, view.width(), view.height());
      REQUIRE(view.valid());
      CHECK(pixels(view) <= kPixelsAtMost);
    }
  }
}

TEST_CASE("a single row of many points stays within as many pixels", "[occupancy][hostile]") {
  PointCloud cloud;
  for (int n = 0; n < 20000; ++n) cloud.points.emplace_back(std::ldexp(1.0F * n, -30), 0.0F, 1.0F);
  cloud.points.emplace_back(2.0F, 0.0F, 1.0F);
  const DepthView view(cloud);
  REQUIRE(view.valid());
  CHECK(pixels(view) <= kPixelsAtMost);
}

TEST_CASE("the pixels of a camera are found as they are", "[occupancy]") {
  PointCloud wall;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) wall.points.push_back(pixel_ray(u, v).cast<float>());
  }
  const DepthView view(wall);
  CHECK(view.width() == kWidth);
  CHECK(view.height() == kHeight);
}
