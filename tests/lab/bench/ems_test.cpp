#include "lab/bench/ems.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/random.hpp"
#include "support/catch.hpp"

namespace quadrille::bench {
namespace {

using scoring::Superquadric;

/// A superquadric in a tilted pose half a metre before the camera.
Superquadric tilted(double e1, double e2, const Eigen::Vector3d& axes) {
  Superquadric S;
  S.exponents << e1, e2;
  S.axes = axes;
  S.X_CS.translation() << 0.1, -0.05, 0.5;
  S.X_CS.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()));
  return S;
}

double normal_number(RandomStream* random) {
  return std::sqrt(-2.0 * std::log(1.0 - random->uniform())) *
         std::cos(2.0 * std::numbers::pi * random->uniform());
}

Eigen::Vector3d normal_vector(RandomStream* random) {
  const double x = normal_number(random), y = normal_number(random);
  return {x, y, normal_number(random)};
}

Eigen::Vector3d uniform_vector(RandomStream* random) {
  const double x = random->uniform(), y = random->uniform();
  return 2.0 * Eigen::Vector3d(x, y, random->uniform()) - Eigen::Vector3d::Ones();
}

/// Points all over a superquadric with noise on each coordinate [m], of which a share is replaced
/// by outliers in a box of twice its size.
std::vector<Eigen::Vector3f> points_on(const Superquadric& S, double sigma, double outliers) {
  RandomStream random(1, 0);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 1000; ++i) {
    Eigen::Vector3d p_S;
    if (random.uniform() < outliers) {
      p_S = 2.0 * S.axes.cwiseProduct(uniform_vector(&random));
    } else {
      const Eigen::Vector3d ray = S.axes.cwiseProduct(normal_vector(&random));
      p_S = ray / S.gauge(ray).value + sigma * normal_vector(&random);
    }
    points.push_back((S.X_CS * p_S).cast<float>());
  }
  return points;
}

/// Returns, for each axis of a fit, the true one to which it is parallel, and checks that each is
/// within an angle [rad] of one.
Eigen::Vector3i partners(const Superquadric& fit, const Superquadric& truth, double tolerance) {
  Eigen::Vector3i axes;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d cosines =
        (truth.X_CS.linear().transpose() * fit.X_CS.linear().col(k)).cwiseAbs();
    CHECK(cosines.maxCoeff(&axes[k]) > std::cos(tolerance));
  }
  return axes;
}

struct Tolerance {
  double metres, exponent, angle;
};

/// Checks all parameters; of the superquadrics of the tests, only the box and the ellipsoid look
/// the same with other axes in the role of z, and the cylinder has no axes across it.
void check_same(const Superquadric& fit, const Superquadric& truth, const Tolerance& tolerance) {
  CHECK((fit.X_CS.translation() - truth.X_CS.translation()).norm() < tolerance.metres);
  CHECK((fit.exponents - truth.exponents).cwiseAbs().maxCoeff() < tolerance.exponent);
  if (truth.axes.x() == truth.axes.y()) {
    CHECK(std::abs(fit.X_CS.linear().col(2).dot(truth.X_CS.linear().col(2))) >
          std::cos(tolerance.angle));
    CHECK((fit.axes - truth.axes).cwiseAbs().maxCoeff() < tolerance.metres);
    return;
  }
  const Eigen::Vector3i axes = partners(fit, truth, tolerance.angle);
  for (int k = 0; k < 3; ++k) {
    CHECK(fit.axes[k] == Approx(truth.axes[axes[k]]).margin(tolerance.metres));
  }
}

const struct {
  const char* name;
  Superquadric truth;
} kShapes[] = {{"ellipsoid", tilted(1.0, 1.0, {0.04, 0.07, 0.11})},
               {"long cylinder", tilted(0.1, 1.0, {0.03, 0.03, 0.1})},
               {"flat cylinder", tilted(0.1, 1.0, {0.09, 0.09, 0.04})},
               {"box", tilted(0.1, 0.1, {0.04, 0.06, 0.1})},
               {"nearly a cube", tilted(0.1, 0.1, {0.05, 0.055, 0.06})},
               {"in between", tilted(0.5, 0.7, {0.04, 0.06, 0.1})}};

TEST_CASE("superquadrics are recovered from exact points", "[bench][ems]") {
  for (const auto& shape : kShapes) {
    INFO(shape.name);
    const auto fit = fit_superquadric(points_on(shape.truth, 0.0, 0.0));
    REQUIRE(fit);
    check_same(fit->superquadric, shape.truth, {1e-4, 5e-3, 2e-3});
    CHECK(fit->sigma < 1e-4);
    CHECK(fit->inliers > 0.99);
  }
}

TEST_CASE("superquadrics are recovered from noisy points", "[bench][ems]") {
  for (const auto& shape : kShapes) {
    INFO(shape.name);
    const auto fit = fit_superquadric(points_on(shape.truth, 0.001, 0.0));
    REQUIRE(fit);
    check_same(fit->superquadric, shape.truth, {1e-3, 0.06, 0.03});
  }
}

TEST_CASE("superquadrics are recovered among outliers", "[bench][ems]") {
  for (const auto& shape : kShapes) {
    INFO(shape.name);
    const auto fit = fit_superquadric(points_on(shape.truth, 0.001, 0.2));
    REQUIRE(fit);
    check_same(fit->superquadric, shape.truth, {1.5e-3, 0.08, 0.03});
    CHECK(fit->inliers == Approx(0.8).margin(0.06));
  }
}

TEST_CASE("a flat cylinder needs a switch to be seen from the right side", "[bench][ems]") {
  const Superquadric truth = tilted(0.1, 1.0, {0.09, 0.09, 0.04});
  const auto points = points_on(truth, 0.001, 0.2);
  EmsOptions options;
  options.max_switches = 0;
  const auto without = fit_superquadric(points, options), with = fit_superquadric(points);
  REQUIRE((without && with));
  CHECK((without->superquadric.exponents - truth.exponents).norm() > 0.5);
  CHECK(without->sigma > 2.0 * with->sigma);
  CHECK(with->switches >= 1);
}

TEST_CASE("the same points give the same superquadric, and moved ones the moved one",
          "[bench][ems][determinism]") {
  const Superquadric truth = tilted(0.1, 1.0, {0.03, 0.03, 0.1});
  const auto points = points_on(truth, 0.001, 0.1);
  const auto fit = fit_superquadric(points), again = fit_superquadric(points);
  REQUIRE((fit && again));
  CHECK(fit->superquadric.axes == again->superquadric.axes);
  CHECK(fit->superquadric.X_CS.matrix() == again->superquadric.X_CS.matrix());
  auto larger = points;
  for (Eigen::Vector3f& p : larger) p = 3.0f * p + Eigen::Vector3f(1, 2, 3);
  const auto other = fit_superquadric(larger);
  REQUIRE(other);
  CHECK((other->superquadric.axes - 3.0 * fit->superquadric.axes).norm() < 1e-3);
}

TEST_CASE("no superquadric is fitted to what determines none", "[bench][ems][degenerate]") {
  RandomStream random(1, 0);
  std::vector<Eigen::Vector3f> plane, line, same(50, Eigen::Vector3f(0.1f, 0.2f, 0.5f));
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector3d p = 0.1 * uniform_vector(&random);
    p.z() = 0.5 + 0.0005 * normal_number(&random);
    plane.push_back(p.cast<float>());
    line.push_back(Eigen::Vector3d(p.x(), 2.0 * p.x(), 0.5).cast<float>());
  }
  CHECK_FALSE(fit_superquadric({}));
  CHECK_FALSE(fit_superquadric({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}));
  CHECK_FALSE(fit_superquadric(plane));
  CHECK_FALSE(fit_superquadric(line));
  CHECK_FALSE(fit_superquadric(same));
  auto points = points_on(tilted(1, 1, {0.04, 0.07, 0.11}), 0.0, 0.0);
  points[0].x() = std::numeric_limits<float>::quiet_NaN();
  CHECK_FALSE(fit_superquadric(points));
}

TEST_CASE("settings of the fit of superquadrics that mean nothing are refused", "[bench][ems]") {
  for (const double outliers : {0.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(fit_superquadric({}, {.outliers = outliers}), std::invalid_argument);
  }
  CHECK_THROWS_AS(fit_superquadric({}, {.max_points = 0}), std::invalid_argument);
  CHECK_THROWS_AS(fit_superquadric({}, {.max_axis = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(fit_superquadric({}, {.max_rounds = 0}), std::invalid_argument);
  CHECK_THROWS_AS(fit_superquadric({}, {.max_switches = -1}), std::invalid_argument);
}

}  // namespace
}  // namespace quadrille::bench
