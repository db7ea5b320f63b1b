#include "samples/depth/coarser_cells.hpp"

#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "detector/samples/depth/pixel_points.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("coarser cells hold all points of one surface and one side of an edge",
          "[depth][cells]") {
  std::vector<Eigen::Vector3f> uvw;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const bool step = i == 2 && j < 2;
      uvw.push_back({0.001f * (i + 0.5f), 0.001f * (j + 0.5f), step ? 0.5f : 1.0f});
    }
  }
  const DepthCells fine = make_depth_cells(cloud_of(uvw), {}, image_of(4, 4, 0.001f), 1);
  const DepthCells all = coarser(fine, {});
  REQUIRE(all.width == 2);
  CHECK(all.pixels == 2);
  CHECK(all.count == std::vector<int>{4, 2, 4, 4});
  CHECK(all.w[0] == 1.0f);
  Mask keep(16, 1);
  keep[0] = keep[1] = keep[4] = keep[5] = 0;
  const DepthCells rest = coarser(fine, keep);
  CHECK(rest.count[0] == 0);
  CHECK(rest.count[3] == 4);
}

TEST_CASE("coarser cells are the means of all points under them, at odd edges too",
          "[depth][cells]") {
  const int width = GENERATE(1, 5, 18, 33), height = GENERATE(1, 3, 4);
  RandomStream random(1, static_cast<std::uint64_t>(width * height));
  std::vector<Eigen::Vector3f> uvw;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      // From none to three points are in a pixel, and no step between them is a depth edge.
      for (int n = random.below(4); n > 0; --n) {
        const auto within = [&](int pixel) {
          return 0.001f * (static_cast<float>(pixel) + 0.1f + 0.8f * random.uniform());
        };
        const auto u = static_cast<float>(within(i)), v = static_cast<float>(within(j));
        uvw.push_back({u, v, 1.0f + 0.001f * static_cast<float>(random.uniform())});
      }
    }
  }
  const PinholeImage image = image_of(width, height, 0.001f);
  const DepthCells coarse = coarser(make_depth_cells(cloud_of(uvw), {}, image, 1), {});
  const DepthCells direct = make_depth_cells(cloud_of(uvw), {}, image, 2);
  REQUIRE(coarse.width == direct.width);
  REQUIRE(coarse.height == direct.height);
  REQUIRE(coarse.count == direct.count);
  for (int c = 0; c < coarse.size(); ++c) {
    INFO("cell " << c);
    CHECK(coarse.u[c] == Approx(direct.u[c]));
    CHECK(coarse.v[c] == Approx(direct.v[c]));
    CHECK(coarse.w[c] == Approx(direct.w[c]));
  }
}
