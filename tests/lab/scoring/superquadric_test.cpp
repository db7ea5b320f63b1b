#include "lab/scoring/superquadric.hpp"

#include <cmath>

#include "support/catch.hpp"

namespace quadrille::scoring {
namespace {

Superquadric posed(double e1, double e2) {
  Superquadric S;
  S.exponents << e1, e2;
  S.axes << 0.1, 0.2, 0.3;
  S.X_CS.translation() << 0.1, -0.2, 1.0;
  S.X_CS.rotate(Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, -1).normalized()));
  return S;
}

const Superquadric kAll[] = {posed(1, 1), posed(0.1, 1), posed(0.02, 0.02), posed(2, 2),
                             posed(1.7, 0.4)};

TEST_CASE("the gauge is that of the superquadric's equation", "[scoring][superquadric]") {
  for (const Superquadric& S : kAll) {
    const Eigen::Vector3d p_S(0.05, -0.11, 0.2);
    const Eigen::Array3d r = p_S.cwiseAbs().cwiseQuotient(S.axes);
    const double e1 = S.exponents[0], e2 = S.exponents[1];
    const double section = std::pow(r.x(), 2 / e2) + std::pow(r.y(), 2 / e2);
    const double F = std::pow(section, e2 / e1) + std::pow(r.z(), 2 / e1);
    CHECK(S.gauge(p_S).value == Approx(std::pow(F, e1 / 2)));
    // It grows in proportion along a ray.
    CHECK(S.gauge(3.0 * p_S).value == Approx(3.0 * S.gauge(p_S).value));
  }
}

TEST_CASE("the gauge's derivatives are those of its values", "[scoring][superquadric]") {
  constexpr double kStep = 1e-6;
  for (const Superquadric& S : kAll) {
    const Eigen::Vector3d p_S(0.05, -0.12, 0.2);
    const Gauge gauge = S.gauge(p_S);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k);
      const double slope = (S.gauge(p_S + step).value - S.gauge(p_S - step).value) / (2 * kStep);
      CHECK(gauge.by_point[k] == Approx(slope).margin(1e-6));
    }
    for (int k = 0; k < 2; ++k) {
      Superquadric more = S, less = S;
      more.exponents[k] += kStep;
      less.exponents[k] -= kStep;
      const double slope = (more.gauge(p_S).value - less.gauge(p_S).value) / (2 * kStep);
      CHECK(gauge.by_exponents[k] == Approx(slope).margin(1e-6));
    }
  }
}

TEST_CASE("value and gradient are in the camera's frame", "[scoring][superquadric]") {
  const Superquadric ball{Eigen::Vector2d::Ones(), Eigen::Vector3d::Constant(0.5),
                          posed(1, 1).X_CS};
  const Eigen::Vector3d ray = Eigen::Vector3d(1, 2, 3).normalized();
  const Eigen::Vector3d p_C = ball.X_CS.translation() + 0.6 * ray;
  CHECK(ball.value(p_C) == Approx(0.2));
  CHECK((ball.gradient(p_C) - 2.0 * ray).norm() < 1e-12);
  // The centre has a value, and no gradient.
  CHECK(ball.value(ball.X_CS.translation()) == -1.0);
  CHECK(ball.gradient(ball.X_CS.translation()).isZero(0.0));
}

TEST_CASE("a line crosses a superquadric twice or not at all", "[scoring][superquadric]") {
  for (const Superquadric& S : kAll) {
    const Eigen::Vector3d c = S.X_CS.translation();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d axis = S.X_CS.linear().col(k);
      const auto [first, second] = S.crossings(c + 0.05 * axis, axis);
      CHECK(first == Approx(-S.axes[k] - 0.05));
      CHECK(second == Approx(S.axes[k] - 0.05));
      const auto beside = S.crossings(c + 0.31 * S.X_CS.linear().col((k + 1) % 3), axis);
      CHECK(std::isnan(beside[0]));
      CHECK(std::isnan(beside[1]));
    }
  }
}

}  // namespace
}  // namespace quadrille::scoring
