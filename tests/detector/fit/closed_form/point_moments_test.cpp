#include "fit/closed_form/point_moments.hpp"

#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the moments are the sums that they stand for, however many points there are",
          "[moments]") {
  RandomStream random(101, 0);
  for (const int size : {1, 7, 128, 300}) {
    const auto points = points_on(diagonal(1, 1.8, 3, -1), size, -1e3, random);
    const PointMoments moments(to_fit_points(points));
    Matrix10d values = Matrix10d::Zero();
    Eigen::Matrix<double, 8, 8> normals = Eigen::Matrix<double, 8, 8>::Zero();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const OrientedPoint& p : points) {
      Eigen::Matrix<double, 8, 1> h;
      h << p.x.cross(p.n), p.n, p.n.dot(p.x), 1.0;
      values += monomials(p.x) * monomials(p.x).transpose();
      normals += h * h.transpose();
      sum += p.x;
      scatter += p.x * p.x.transpose();
    }
    CAPTURE(size);
    CHECK(moments.size == size);
    CHECK((moments.values - values).norm() < 1e-5 * values.norm());
    CHECK((moments.normals - normals).norm() < 1e-5 * normals.norm());
    CHECK((moments.centre() - sum / size).norm() < 1e-5);
    CHECK((moments.scatter() - scatter).norm() < 1e-5 * scatter.norm());
  }
}

TEST_CASE("a quadratic function that others add up to has their factors", "[moments]") {
  RandomStream random(102, 0);
  const PointMoments moments(to_fit_points(points_on(diagonal(1, 1.8, 3, -1), 60, -1e3, random)));
  const Eigen::Vector3d b(0.3, -0.2, 0.5);
  Eigen::Matrix<double, 10, 3> columns;
  columns.col(0) = quadratic(Eigen::Vector3d(1, 2, -1).asDiagonal(), b, 0.1);
  columns.col(1) = quadratic(Eigen::Matrix3d::Zero(), b, 1.0);
  columns.col(2) = 2.0 * columns.col(0) - 0.7 * columns.col(1);
  CHECK((least_squares(moments, columns) - Eigen::Vector2d(2.0, -0.7)).norm() < 1e-9);
}
