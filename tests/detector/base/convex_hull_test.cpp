#include "base/convex_hull.hpp"

#include <cmath>
#include <random>
#include <vector>

#include "support/catch.hpp"

namespace quadrille {
namespace {

/// Area of a polygon whose corners come counterclockwise (shoelace formula).
double area_of(const std::vector<Eigen::Vector2d>& corners) {
  double area = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector2d& a = corners[k];
    const Eigen::Vector2d& b = corners[(k + 1) % corners.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

TEST_CASE("the hull of points in a square is the square", "[convex_hull]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> inside(-1.0, 1.0);
  std::vector<Eigen::Vector2d> points = {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}, {1, 0}, {-1, -1}};
  for (int n = 0; n < 100; ++n) points.emplace_back(inside(random), inside(random));
  const std::vector<Eigen::Vector2d> hull = convex_hull(points);
  CHECK(hull.size() == 4);
  CHECK(area_of(hull) == Approx(4.0));
}

TEST_CASE("the hull of a circle has all its points as corners", "[convex_hull]") {
  std::vector<Eigen::Vector2d> points;
  for (int n = 0; n < 60; ++n) {
    points.emplace_back(std::cos(2.0 * M_PI * n / 60), std::sin(2.0 * M_PI * n / 60));
  }
  const std::vector<Eigen::Vector2d> hull = convex_hull(points);
  CHECK(hull.size() == 60);
  CHECK(area_of(hull) == Approx(30.0 * std::sin(2.0 * M_PI / 60)));
}

TEST_CASE("points on a line, one point and none have no hull with an area", "[convex_hull]") {
  CHECK(convex_hull({}).empty());
  CHECK(convex_hull({{1, 2}}).size() < 3);
  CHECK(convex_hull({{0, 0}, {1, 1}, {3, 3}, {2, 2}}).size() < 3);
}

}  // namespace
}  // namespace quadrille
