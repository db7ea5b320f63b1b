#include "quadrille/detector/quadric.hpp"

#include "support/catch.hpp"

using quadrille::Quadric;
using quadrille::Vector10d;

namespace {

Quadric sphere(double r) {
  return Quadric(Eigen::Matrix4d(Eigen::Vector4d(1, 1, 1, -r * r).asDiagonal()));
}

}  // namespace

TEST_CASE("the ten coefficients and the matrix hold the same quadric", "[quadric][paper:eq1]") {
  const Vector10d q = Vector10d::LinSpaced(1.0, 10.0);
  const Quadric Q(q);
  CHECK(Q.coefficients() == q);
  const double x = 0.3, y = -0.7, z = 1.1;
  Vector10d v;
  v << x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z, 2 * x, 2 * y, 2 * z, 1;
  CHECK(Q.value({x, y, z}) == Approx(q.dot(v)));
}

TEST_CASE("the first-order distance of a sphere is exact on its surface's linear order",
          "[quadric]") {
  CHECK(sphere(2.0).distance({2.001, 0, 0}) == Approx(0.001).epsilon(1e-3));
  CHECK(sphere(2.0).distance({1.999, 0, 0}) == Approx(-0.001).epsilon(1e-3));
  CHECK(std::isinf(sphere(2.0).distance({0, 0, 0})));
}

TEST_CASE("a transformed quadric holds the transformed points", "[quadric]") {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  X.pretranslate(Eigen::Vector3d(0.4, -0.2, 0.9));
  const Quadric moved = sphere(1.0).transformed(X);
  const Eigen::Vector3d on = X * Eigen::Vector3d(0, 0.6, 0.8);
  CHECK(moved.value(on) == Approx(0.0).margin(1e-12));
  CHECK(moved.gradient(on).normalized().isApprox(X.linear() * Eigen::Vector3d(0, 0.6, 0.8), 1e-12));
}
