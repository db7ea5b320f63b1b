#include "quadrille/detector/quadric.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "support/catch.hpp"

using quadrille::Quadric;
using quadrille::Vector10d;

namespace {

Quadric sphere_quadric(double r) {
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
  CHECK(sphere_quadric(2.0).distance({2.001, 0, 0}) == Approx(0.001).epsilon(1e-3));
  CHECK(sphere_quadric(2.0).distance({1.999, 0, 0}) == Approx(-0.001).epsilon(1e-3));
  CHECK(std::isinf(sphere_quadric(2.0).distance({0, 0, 0})));
}

TEST_CASE("a line crosses a quadric where it passes through, and not where it touches",
          "[quadric]") {
  const auto crossings = [](const Quadric& Q, const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
    std::vector<double> finite;
    for (const double t : Q.crossings(o, d)) {
      if (std::isfinite(t)) finite.push_back(t);
    }
    return finite;
  };
  const Eigen::Vector3d along = Eigen::Vector3d::UnitX(), across = Eigen::Vector3d::UnitY();
  const Quadric ball = sphere_quadric(1.0);
  Eigen::Matrix4d flat = Eigen::Matrix4d::Zero();
  flat(0, 3) = flat(3, 0) = 0.5;
  flat(3, 3) = -2.0;
  const Quadric plane(flat);
  CHECK(crossings(ball, {-3, 0, 0}, along) == std::vector<double>{2.0, 4.0});
  CHECK(crossings(ball, {3, 0, 0}, along) == std::vector<double>{-2.0, -4.0});
  // The second line starts on the ball itself.
  CHECK(crossings(ball, {-1, 0, 0}, along) == std::vector<double>{0.0, 2.0});
  CHECK(crossings(ball, {-3, 2, 0}, along).empty());
  // Here b² = ac, with the contact before the start and at it.
  CHECK(crossings(ball, {-3, 1, 0}, along).empty());
  CHECK(crossings(ball, {0, 1, 0}, along).empty());
  CHECK(crossings(plane, {0, 5, 0}, along) == std::vector<double>{2.0});
  CHECK(crossings(plane, {0, 5, 0}, across).empty());
  // This line lies in the plane.
  CHECK(crossings(plane, {2, 5, 0}, across).empty());
}

TEST_CASE("a transformed quadric holds the transformed points", "[quadric]") {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  X.pretranslate(Eigen::Vector3d(0.4, -0.2, 0.9));
  const Quadric moved = sphere_quadric(1.0).transformed(X);
  const Eigen::Vector3d on = X * Eigen::Vector3d(0, 0.6, 0.8);
  CHECK(moved.value(on) == Approx(0.0).margin(1e-12));
  CHECK(moved.gradient(on).normalized().isApprox(X.linear() * Eigen::Vector3d(0, 0.6, 0.8), 1e-12));
}

TEST_CASE("the tangent planes of a quadric lie on its dual", "[quadric][paper:def2]") {
  Eigen::Matrix4d saddle = Eigen::Vector4d(1, -2, 0, 0.3).asDiagonal();
  saddle(2, 3) = saddle(3, 2) = 0.7;
  // 1.4 z = 2 y² − x² − 0.3 at x = 0.2, y = 0.5.
  const std::vector<std::pair<Quadric, Eigen::Vector4d>> cases = {
      {sphere_quadric(1.5), {0.9, 0, 1.2, 1}}, {Quadric(saddle), {0.2, 0.5, 0.16 / 1.4, 1}}};
  for (const auto& [Q, on] : cases) {
    // Q x is the tangent plane at a point x of the quadric.
    const Eigen::Vector4d plane = Q.matrix() * on;
    CHECK(plane.dot(Q.dual() * plane) == Approx(0.0).margin(1e-12));
    const Eigen::Vector4d other = plane + Eigen::Vector4d(0, 0, 0, 0.5);
    CHECK(std::abs(other.dot(Q.dual() * other)) > 0.05);
    // The adjugate: Q Q* = det Q.
    const double det = Q.matrix().determinant();
    CHECK((Q.matrix() * Q.dual()).isApprox(det * Eigen::Matrix4d::Identity(), 1e-12));
  }
}

TEST_CASE("the dual of a cone has rank 1 and that of two planes vanishes", "[quadric]") {
  const Quadric cone(Eigen::Matrix4d(Eigen::Vector4d(1, 1, -2, 0).asDiagonal()));
  Eigen::Matrix4d expected = Eigen::Matrix4d::Zero();
  expected(3, 3) = -2.0;
  CHECK(cone.dual().isApprox(expected, 1e-15));
  const Quadric planes(Eigen::Matrix4d(Eigen::Vector4d(1, -1, 0, 0).asDiagonal()));
  CHECK(planes.dual().isZero(0.0));
}

TEST_CASE("a projective map carries the points of a quadric along", "[quadric]") {
  Eigen::Projective3d P = Eigen::Projective3d::Identity();
  P.matrix() << 1, 0.2, 0, 0.3, 0, 2, 0.1, 0, 0.1, 0, 1, -0.4, 0.2, 0.1, 0, 3;
  const Eigen::Vector4d on = P.matrix() * Eigen::Vector4d(0, 0.6, 0.8, 1);
  CHECK(sphere_quadric(1.0).transformed(P).value(on.hnormalized()) == Approx(0.0).margin(1e-12));
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.pretranslate(Eigen::Vector3d(1, 2, 3));
  CHECK(sphere_quadric(2.0).transformed(X).matrix().isApprox(
      sphere_quadric(2.0).transformed(Eigen::Projective3d(X)).matrix(), 1e-12));
  P.matrix().row(3) = P.matrix().row(2);
  CHECK_THROWS_AS(sphere_quadric(1.0).transformed(P), std::invalid_argument);
}
