#include "samples/depth/depth_cells.hpp"

#include <cmath>
#include <numbers>

#include "detector/samples/depth/pixel_points.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A wall across the view at depth z.
Patch wall(double z) { return rectangle(translation(0, 0, z), 1e3, 1e3); }

}  // namespace

TEST_CASE("a cell is the mean of its points in tangents and inverse depth", "[depth][cells]") {
  const DepthCells cells = make_depth_cells(
      cloud_of({{0.001f, 0.001f, 1.0f}, {0.003f, 0.001f, 1.002f}, {0.009f, 0.001f, 0.5f}}), {},
      image_of(8, 2, 0.002f), 2);
  REQUIRE(cells.width == 4);
  REQUIRE(cells.height == 1);
  CHECK(cells.count == std::vector<int>{2, 0, 1, 0});
  CHECK(cells.u[0] == Approx(0.002f));
  CHECK(cells.w[0] == Approx(1.001f));
  CHECK(cells.w[2] == Approx(0.5f));
  CHECK(cells.metric(0.5f) == Approx(0.008f));
  CHECK((cells.position_V(2) - Eigen::Vector3f(0.018f, 0.002f, 2.0f)).norm() < 1e-6f);
}

TEST_CASE("means in inverse depth keep a tilted plane exactly", "[depth][cells]") {
  Eigen::Isometry3d X = translation(0, 0, 1.2);
  X.rotate(Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 0.4, 0).normalized()));
  const PointCloud cloud = render({rectangle(X, 1e3, 1e3)});
  const auto view = find_view(cloud);
  REQUIRE(view);
  const DepthCells cells = make_depth_cells(cloud, *view, *find_image(cloud, *view), 4);
  const Eigen::Vector3d n = X.linear().col(2);
  const double d = n.dot(X.translation());
  int looked = 0;
  for (int c = 0; c < cells.size(); ++c) {
    if (cells.count[c] == 0) continue;
    ++looked;
    REQUIRE(std::abs(n.dot(cells.position_V(c).cast<double>()) - d) < 2e-5 / cells.w[c]);
  }
  CHECK(looked > 4000);
}

TEST_CASE("a cell across a depth edge keeps the side with more points", "[depth][cells]") {
  const float near = 1.0f, far = 0.5f;
  const auto kept = [&](int nears, int fars) {
    std::vector<Eigen::Vector3f> uvw;
    for (int k = 0; k < nears; ++k) uvw.push_back({0.001f, 0.001f, near});
    for (int k = 0; k < fars; ++k) uvw.push_back({0.003f, 0.003f, far});
    const DepthCells cells = make_depth_cells(cloud_of(uvw), {}, image_of(4, 4, 0.001f), 4);
    CHECK(cells.count[0] == std::max(nears, fars));
    return cells.w[0];
  };
  CHECK(kept(3, 2) == near);
  CHECK(kept(2, 3) == far);
}

TEST_CASE("a step in depth is continuous up to the slope seen at 75 degrees", "[depth][cells]") {
  DepthCells cells;
  cells.image = image_of(1, 1, 0.003f);
  cells.pixels = 1;
  const float step = continuous_step(cells, 1.0f);
  CHECK(step > std::tan(75.0 * std::numbers::pi / 180.0) * 0.003 * 0.98);
  CHECK(continuous(cells, 1.0f, 1.0f / (1.0f + 0.7f * step)));
  CHECK_FALSE(continuous(cells, 1.0f, 1.0f / (1.0f + 1.3f * step)));
}

TEST_CASE("layers tell a fused cloud from a single view", "[depth][cells]") {
  PointCloud single = render({wall(1.0), sphere(translation(0, 0, 0.7), 0.1)});
  PointCloud fused = single;
  const PointCloud behind = render({wall(1.3)});
  fused.points.insert(fused.points.end(), behind.points.begin(), behind.points.end());
  fused.width = fused.height = 0;
  const auto layered = [](const PointCloud& cloud) {
    const auto view = find_view(cloud);
    return make_depth_cells(cloud, *view, *find_image(cloud, *view), 3).layered;
  };
  CHECK(layered(single) < 0.0002);
  CHECK(layered(fused) > 0.9);
}

TEST_CASE("an image one cell wide or high has layers, but no area of them", "[depth][cells]") {
  std::vector<Eigen::Vector3f> column, row;
  for (int k = 0; k < 64; ++k) {
    const float along = 0.001f * static_cast<float>(k) + 0.0005f;
    for (const float w : {1.0f, 1.0f, 0.5f}) {
      column.push_back({0.001f, along, w});
      row.push_back({along, 0.001f, w});
    }
  }
  CHECK(make_depth_cells(cloud_of(column), {}, image_of(4, 64, 0.001f), 4).layered == 0.0);
  CHECK(make_depth_cells(cloud_of(row), {}, image_of(64, 4, 0.001f), 4).layered == 0.0);
}
