#include <cmath>

#include "picture/cloud_layer.hpp"
#include "picture/view.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// A wall, its left half red and its right half blue, with a green point before its middle and a
/// missing one.
PointCloud coloured_wall() {
  PointCloud cloud;
  cloud.points = {Eigen::Vector3f::Constant(std::nanf(""))};
  cloud.colours = {{255, 255, 255}};
  for (int i = -60; i < 60; ++i) {
    for (int j = -40; j < 40; ++j) {
      cloud.points.push_back({0.01f * i, 0.01f * j, 1.0f});
      cloud.colours.push_back(i < 0 ? Rgb{255, 0, 0} : Rgb{0, 0, 255});
    }
  }
  cloud.points.push_back({0.0f, 0.0f, 0.9f});
  cloud.colours.push_back({0, 255, 0});
  return cloud;
}

Color pixel_of(const PointCloud& cloud, const Eigen::Vector3d& p) {
  const View view = fit_view(cloud, 320);
  Image image(view.width, view.height, Color(0, 0, 0));
  draw_cloud(cloud_image(cloud, view), view, &image);
  const Eigen::Vector2i at = view.project(p)->cast<int>();
  return image.at(at.x(), at.y());
}

}  // namespace

TEST_CASE("points are drawn in their own colours, the nearest before the others",
          "[picture][colours]") {
  const PointCloud cloud = coloured_wall();
  CHECK(pixel_of(cloud, {-0.3, 0.1, 1.0}) == Color(1, 0, 0));
  CHECK(pixel_of(cloud, {0.3, 0.1, 1.0}) == Color(0, 0, 1));
  CHECK(pixel_of(cloud, {0.0, 0.0, 0.9}) == Color(0, 1, 0));
}

TEST_CASE("points without colours are drawn in grey", "[picture][colours]") {
  PointCloud cloud = coloured_wall();
  cloud.colours.clear();
  const Color grey = pixel_of(cloud, {-0.3, 0.1, 1.0});
  CHECK(grey.x() > 0.1f);
  CHECK(grey.x() == grey.y());
  CHECK(grey.x() == grey.z());
}
