#include "planes/planes.hpp"

#include <cmath>
#include <set>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Two planes that meet at a right angle in the middle column.
SurfaceSamples edge_grid(double noise) {
  return surface_grid(
      40, 20,
      [](int i, int j) {
        const double s = (i - 19.5) * 0.01, z = j * 0.01;
        return s < 0 ? OrientedPoint{{0, -s, z}, Eigen::Vector3d::UnitX()}
                     : OrientedPoint{{s, 0, z}, Eigen::Vector3d::UnitY()};
      },
      0.01, noise, 3);
}

}  // namespace

TEST_CASE("a table is found whole, with its equation and normal side", "[planes]") {
  const SurfaceSamples samples = plane_grid(50, 40, 0.01, 0.001, 1);
  const auto planes = find_planes(samples, {});
  REQUIRE(planes.size() == 1);
  CHECK(planes[0].samples.size() >= 1960);
  CHECK(planes[0].plane.head<3>().norm() == Approx(1.0));
  CHECK(planes[0].plane.x() > 0.99999);
  // The mean of 2000 samples of 1 mm noise.
  CHECK(std::abs(planes[0].plane[3]) < 1e-4);
}

TEST_CASE("two faces of an edge are two planes that share no sample", "[planes]") {
  const auto planes = find_planes(edge_grid(0.0005), {});
  REQUIRE(planes.size() == 2);
  std::set<int> members;
  for (const PlaneRegion& plane : planes) {
    members.insert(plane.samples.begin(), plane.samples.end());
    CHECK(plane.plane.head<2>().cwiseAbs().maxCoeff() > 0.999);
  }
  CHECK(members.size() == planes[0].samples.size() + planes[1].samples.size());
  CHECK(members.size() > 760);
  CHECK(std::abs(planes[0].plane.head<3>().dot(planes[1].plane.head<3>())) < 0.02);
}

TEST_CASE("neither a cylinder nor a strip of it nor a sphere is a plane", "[planes]") {
  CHECK(find_planes(cylinder_grid(24, 60, 0.05, 0.005, 0.0005, 1), {}).empty());
  // Along its axis a cylinder is as straight as a table.
  CHECK(find_planes(cylinder_grid(6, 80, 0.05, 0.005, 0.001, 2), {}).empty());
  CHECK(find_planes(sphere_grid(40, 40, 0.15, 0.01, 0.001, 3), {}).empty());
}

TEST_CASE("what bends less than the least radius is a plane", "[planes]") {
  CHECK(find_planes(cylinder_grid(60, 60, 0.4, 0.005, 0.001, 4), {}).empty());
  CHECK(find_planes(cylinder_grid(60, 60, 20.0, 0.005, 0.001, 5), {}).size() == 1);
}

TEST_CASE("a plane has the least number of samples, or is none", "[planes]") {
  PlaneOptions options;
  options.min_samples = 400;
  CHECK(find_planes(plane_grid(20, 20, 0.02, 0.0, 1), options).size() == 1);
  options.min_samples = 401;
  CHECK(find_planes(plane_grid(20, 20, 0.02, 0.0, 1), options).empty());
}

TEST_CASE("parts of a plane that turn different sides are one plane", "[planes]") {
  const SurfaceSamples samples = surface_grid(
      40, 20,
      [](int i, int j) {
        const Eigen::Vector3d x(i * 0.01, j * 0.01, 0.0);
        return OrientedPoint{x, (i < 15 ? -1.0 : 1.0) * Eigen::Vector3d::UnitZ()};
      },
      0.01, 0.0005, 4);
  const auto planes = find_planes(samples, {});
  REQUIRE(planes.size() == 1);
  CHECK(planes[0].samples.size() > 780);
  CHECK(planes[0].plane.z() > 0.9999);
}

TEST_CASE("no samples, no planes", "[planes][degenerate]") {
  CHECK(find_planes(plane_grid(0, 0, 0.01, 0.0, 1), {}).empty());
}

TEST_CASE("samples that another surface holds do not tilt a plane's start", "[planes]") {
  // Every free sample has one claimed neighbour, which stands out.
  SurfaceSamples samples = plane_grid(30, 30, 0.01, 0.0005, 7);
  Mask free(samples.p.size(), 1);
  for (int row = 1; row < 30; row += 3) {
    for (int column = 1; column < 30; column += 3) {
      const int i = row * 30 + column;
      free[i] = 0;
      samples.raw[i].x() += 0.05f;
    }
  }
  const auto planes = find_planes(samples, {}, free);
  REQUIRE(planes.size() == 1);
  CHECK(planes[0].samples.size() == 800);
  CHECK(planes[0].plane.x() > 0.9999);
}

TEST_CASE("samples that another surface holds belong to no plane", "[planes]") {
  const SurfaceSamples samples = edge_grid(0.0005);
  Mask free(samples.p.size(), 1);
  for (int i = 0; i < samples.size(); ++i) free[i] = samples.n[i].y() <= 0.7f;
  const auto planes = find_planes(samples, {}, free);
  REQUIRE(planes.size() == 1);
  for (const int i : planes[0].samples) CHECK(free[i]);
  CHECK(planes[0].samples.size() > 380);
}

TEST_CASE("the normal of the largest plane", "[planes]") {
  CHECK_FALSE(normal_of_largest({}));
  const std::vector<PlaneRegion> planes = {
      {{0, 1, 0, 0}, {1}}, {{1, 0, 0, 2}, {2, 3}}, {{0, 0, 1, 0}, {4, 5}}};
  CHECK(*normal_of_largest(planes) == Eigen::Vector3d::UnitX());
}
