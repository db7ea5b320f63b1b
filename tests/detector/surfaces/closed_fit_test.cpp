#include "surfaces/closed_fit.hpp"

#include <cmath>
#include <vector>

#include "fit/geometric_fit.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kNoise = 0.01;

/// Points of the mantle with semi-axes 1 and b, of height 2, within `half` of a direction.
Wall wall_of(double b, double middle, double half, RandomStream& random) {
  constexpr int kPoints = 150;
  OrientedPointsf points(kPoints);
  points.normals.setZero();
  for (int k = 0; k < kPoints; ++k) {
    const double angle = middle + half * (2.0 * random.uniform() - 1.0);
    const Eigen::Vector3d x(std::cos(angle), b * std::sin(angle), 2.0 * random.uniform() - 1.0);
    const Eigen::Vector3d n = Eigen::Vector3d(b * x.x(), x.y() / b, 0.0).normalized();
    points.points.col(k) = (x + kNoise * gaussian(random) * n).cast<float>();
  }
  PosedQuadric start;
  start.D = diagonal(1.0, 1.0, 0.0, -1.0);
  start.X.translation() << 0.1, 0.1, 0.0;
  const auto fit = refine(points, Family::kCylinder, start, 20);
  REQUIRE(fit);
  return {*fit, points, 40.0, 0.02};
}

/// Places around an ellipse with semi-axes `a` and `b` at the upper end of the mantle.
std::vector<OutlinePoint> outline_of_ellipse(double a, double b, double from, double to,
                                             RandomStream& random) {
  constexpr double kStd = 0.02;
  std::vector<OutlinePoint> outline;
  for (int k = 0; k < 30; ++k) {
    const double angle = from + (to - from) * k / 29.0;
    const double out = 1.0 + kStd * gaussian(random);
    outline.push_back({{out * a * std::cos(angle), out * b * std::sin(angle), 1.0}, kStd});
  }
  return outline;
}

std::vector<double> semi_axes(const FamilyFit& fit) {
  std::vector<double> values;
  for (const auto& [name, value] : canonical_form(fit.posed).dimensions) values.push_back(value);
  return values;
}

}  // namespace

TEST_CASE("the outline of a lid tells the section of which the wall shows a part", "[fit]") {
  RandomStream random(3, 0);
  for (const double b : {1.0, 0.6}) {
    for (const double middle : {0.0, 0.7, M_PI / 2.0}) {
      for (const double half : {0.6, 0.9, 1.4}) {
        const Wall wall = wall_of(b, middle, half, random);
        const auto outline =
            outline_of_ellipse(1.0, b, middle + 1.4, middle + 2.0 * M_PI - 1.4, random);
        const auto closed = fit_closed(wall, outline);
        CAPTURE(b, middle, half);
        REQUIRE(closed);
        CHECK(closed->fit.family == (b == 1.0 ? Family::kCylinder : Family::kEllipticCylinder));
        CHECK(closed->points.size() >= wall.points.size() + 28);
        const std::vector<double> axes = semi_axes(closed->fit);
        CHECK(axes.front() == Approx(1.0).margin(0.02));
        CHECK(axes.back() == Approx(b).margin(0.02));
        CHECK(closed->common_error > 0.0);
        CHECK(closed->common_error < 0.02);
      }
    }
  }
}

TEST_CASE("strays do not move the section", "[fit]") {
  RandomStream random(4, 0);
  const Wall wall = wall_of(0.6, M_PI / 2.0, 0.8, random);
  auto outline = outline_of_ellipse(1.0, 0.6, M_PI, 2.0 * M_PI, random);
  for (const std::size_t k : {3, 11, 12, 25}) outline[k].p_C.head<2>() *= 1.3;
  const auto closed = fit_closed(wall, outline);
  REQUIRE(closed);
  CHECK(semi_axes(closed->fit).front() == Approx(1.0).margin(0.03));
  CHECK(semi_axes(closed->fit).back() == Approx(0.6).margin(0.03));
}

TEST_CASE("the outline of another body does not close a wall", "[fit]") {
  RandomStream random(5, 0);
  const Wall wall = wall_of(1.0, 0.0, 1.2, random);
  // A plate that overhangs the wall, and a square one.
  auto overhanging = outline_of_ellipse(1.6, 1.6, 1.4, 2.0 * M_PI - 1.4, random);
  for (OutlinePoint& o : overhanging) o.p_C.x() += 0.3;
  CHECK_FALSE(fit_closed(wall, overhanging));
  std::vector<OutlinePoint> square;
  for (int k = 0; k < 10; ++k) {
    for (const double side : {-1.0, 1.0})
      square.push_back({{-0.4 + 0.15 * k, side * 1.5, 1.0}, 0.02});
    square.push_back({{-1.2, -1.5 + 0.3 * k, 1.0}, 0.02});
  }
  CHECK_FALSE(fit_closed(wall, square));
}

TEST_CASE("a few points of an outline close nothing", "[fit]") {
  RandomStream random(6, 0);
  const Wall wall = wall_of(0.6, 0.0, 0.8, random);
  auto outline = outline_of_ellipse(1.0, 0.6, 2.0, 4.0, random);
  outline.resize(7);
  CHECK_FALSE(fit_closed(wall, outline));
  CHECK_FALSE(fit_closed(wall, {}));
}
