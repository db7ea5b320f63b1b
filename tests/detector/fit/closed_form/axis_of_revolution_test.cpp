#include "fit/closed_form/axis_of_revolution.hpp"

#include "fit/closed_form/point_moments.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the axis of a surface of revolution is found in both precisions",
          "[axis_of_revolution]") {
  RandomStream random(98, 0);
  for (int trial = 0; trial < 10; ++trial) {
    const Eigen::Isometry3d X = random_pose(random, 0.3);
    std::vector<OrientedPoint> points = points_on(diagonal(1, 1, -0.6, -0.3), 100, -1e3, random);
    for (OrientedPoint& p : points) p = {X * p.x, X.linear() * p.n};
    const Eigen::Vector3d direction = X.linear().col(2);
    const Eigen::Vector3d foot = X.translation() - direction.dot(X.translation()) * direction;
    const auto exact = axis_of_revolution(to_oriented_points<double>(points), 0.0);
    const PointMoments moments(to_oriented_points<float>(points));
    const auto rounded = axis_of_revolution(moments.normals.topLeftCorner<6, 6>(), 1e-9);
    REQUIRE((exact && rounded));
    CHECK(exact->direction.cross(direction).norm() < 1e-9);
    CHECK((exact->foot - foot).norm() < 1e-9);
    CHECK(exact->misfits[0] < 1e-12 * exact->misfits[1]);
    CHECK(rounded->direction.cross(direction).norm() < 1e-4);
    CHECK((rounded->foot - foot).norm() < 1e-4);
  }
}

TEST_CASE("every line through a sphere's centre is an axis", "[axis_of_revolution]") {
  RandomStream random(99, 0);
  const auto points = points_on(diagonal(1, 1, 1, -0.81), 100, -1e3, random);
  const auto axis = axis_of_revolution(to_oriented_points<double>(points), 0.0);
  REQUIRE(axis);
  CHECK(axis->misfits[2] < 1e-12);
}
