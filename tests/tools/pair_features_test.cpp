#include "lab/experiments/pair_features.hpp"

#include <cmath>

#include "lab/experiments/random_quadric.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::experiments;

namespace {

/// The half of a cylinder's side that is seen from the origin, a point every `cell`.
OrientedPointsd half_side(const KnownCylinder& cylinder, double length, double cell) {
  std::vector<OrientedPoint> points;
  const Eigen::Vector3d side = cylinder.axis_C.unitOrthogonal();
  const Eigen::Vector3d other = cylinder.axis_C.cross(side);
  for (double h = -0.5 * length; h <= 0.5 * length; h += cell) {
    for (double turn = 0.0; turn < 2.0 * M_PI; turn += cell / cylinder.radius) {
      const Eigen::Vector3d n = std::cos(turn) * side + std::sin(turn) * other;
      const Eigen::Vector3d x = cylinder.centre_C + cylinder.radius * n + h * cylinder.axis_C;
      if (n.dot(x) < 0.0) points.push_back({x, n});
    }
  }
  OrientedPointsd result(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.points.col(static_cast<Eigen::Index>(i)) = points[i].x;
    result.normals.col(static_cast<Eigen::Index>(i)) = points[i].n;
  }
  return result;
}

}  // namespace

TEST_CASE("point pairs of half a cylinder give its pose", "[experiment][pairs]") {
  const KnownCylinder truth{{0.05, -0.02, 0.7}, Eigen::Vector3d(0.8, 0.5, 0.2).normalized(), 0.018};
  OrientedPointsd points = half_side(truth, 0.09, 0.005);
  RandomStream random(3, 0);
  add_point_noise(&points, 0.0003, random);
  add_normal_noise(&points, 0.05, random);
  const auto found = match_pairs(points, 0.005, {});
  REQUIRE(found.size() == 1);
  CHECK(found[0].axis_C.cross(truth.axis_C).norm() < 0.03);
  CHECK((found[0].centre_C - truth.centre_C).norm() < 0.01);
  const Eigen::Vector3d off = found[0].centre_C - truth.centre_C;
  CHECK(truth.axis_C.cross(off).norm() < 0.001);
}

TEST_CASE("point pairs of a plane give no cylinder", "[experiment][pairs]") {
  OrientedPointsd points(400);
  for (Eigen::Index i = 0; i < 400; ++i) {
    points.points.col(i) << 0.005 * static_cast<double>(i % 20),
        0.005 * static_cast<double>(i / 20), 0.7;
    points.normals.col(i) = -Eigen::Vector3d::UnitZ();
  }
  CHECK(match_pairs(points, 0.005, {}).empty());
}
