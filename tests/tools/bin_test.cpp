#include "lab/scene/bin.hpp"

#include <algorithm>
#include <cmath>

#include "lab/scene/render.hpp"
#include "lab/scene/segment.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::scene;
using Eigen::Vector3d;

namespace {

std::vector<Segment> axes_of(const Layout& layout, double length) {
  std::vector<Segment> axes;
  for (const Body& body : layout.bodies) {
    if (body.type != "cylinder") continue;
    axes.push_back({body.X_WB.translation(), body.X_WB * Vector3d(0, 0, length)});
  }
  return axes;
}

/// Lowest point of a flat-ended cylinder.
double lowest(const Segment& axis, double radius) {
  const Vector3d along = (axis.b - axis.a).normalized();
  return std::min(axis.a.z(), axis.b.z()) - radius * along.head<2>().norm();
}

}  // namespace

TEST_CASE("the distance of segments is that of their nearest points", "[scene][bin]") {
  const Segment x{{0, 0, 0}, {2, 0, 0}};
  // Crossing, beside the end, parallel with and without overlap, and a single point.
  CHECK(distance(x, {{1, -1, 3}, {1, 1, 3}}) == Approx(3.0));
  CHECK(distance(x, {{5, -1, 4}, {5, 1, 4}}) == Approx(5.0));
  CHECK(distance(x, {{1, 2, 0}, {4, 2, 0}}) == Approx(2.0));
  CHECK(distance(x, {{5, 4, 0}, {9, 4, 0}}) == Approx(5.0));
  CHECK(distance(x, {{1, 0, 7}, {1, 0, 7}}) == Approx(7.0));
  CHECK(distance(x, {{1, -1, 0}, {1, 1, 0}}) == Approx(0.0).margin(1e-12));
  Random random(11, 0);
  const auto point = [&] {
    return Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform());
  };
  for (int k = 0; k < 50; ++k) {
    const Segment s{point(), point()}, t{point(), point()};
    double least = 1e9;
    for (int i = 0; i <= 60; ++i) {
      for (int j = 0; j <= 60; ++j) {
        const Vector3d p = s.a + i / 60.0 * (s.b - s.a), q = t.a + j / 60.0 * (t.b - t.a);
        least = std::min(least, (p - q).norm());
      }
    }
    CHECK(distance(s, t) <= least + 1e-12);
    CHECK(distance(s, t) > least - 0.04);
    CHECK(distance(s, t) == Approx(distance(t, s)));
  }
}

TEST_CASE(
    "the cylinders of a bin lie in the tray, on it or on each other, and not within each other",
    "[scene][bin]") {
  BinOptions options;
  options.cylinders = 30;
  Random random(12, 0);
  const Layout layout = fill_bin(options, &random);
  const std::vector<Segment> axes = axes_of(layout, options.length);
  REQUIRE(axes.size() == 30);
  int leaning = 0, above = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    double gap = lowest(axes[i], options.radius);
    CHECK(gap >= -1e-9);
    above += gap > options.radius;
    leaning += std::abs(axes[i].a.z() - axes[i].b.z()) > 0.1 * options.length;
    for (const Vector3d& end : {axes[i].a, axes[i].b}) {
      CHECK(std::abs(end.x()) <= options.half_x - options.radius + 1e-9);
      CHECK(std::abs(end.y()) <= options.half_y - options.radius + 1e-9);
    }
    for (std::size_t j = 0; j < axes.size(); ++j) {
      if (i == j) continue;
      const double apart = distance(axes[i], axes[j]) - 2.0 * options.radius;
      CHECK(apart >= 0.0);
      if (j < i) gap = std::min(gap, apart);
    }
    CHECK(gap < 1e-3);
  }
  CHECK(above >= 5);
  CHECK(leaning >= 3);
}

TEST_CASE("a bin's sides are seen from above, and the same seed fills it alike",
          "[scene][bin][determinism]") {
  Random one(13, 0), two(13, 0);
  const Layout layout = fill_bin({}, &one);
  const Layout again = fill_bin({}, &two);
  REQUIRE(layout.bodies.size() == again.bodies.size());
  for (std::size_t i = 0; i < layout.bodies.size(); ++i) {
    CHECK(layout.bodies[i].X_WB.matrix() == again.bodies[i].X_WB.matrix());
    CHECK(std::abs(layout.bodies[i].X_WB.linear().determinant() - 1.0) < 1e-12);
  }
  const quadrille::scene::Rendering view =
      render(Camera::of_size(320, 240), layout.bodies, layout.X_CW);
  int seen = 0;
  std::size_t id = 0;
  for (const Body& body : layout.bodies) {
    for (const Surface& surface : body.surfaces) {
      seen += surface.curved && view.visible[id] > 75;
      ++id;
    }
  }
  CHECK(seen >= 10);
  BinOptions narrow;
  narrow.half_y = 0.04;
  CHECK_THROWS_AS(fill_bin(narrow, &one), std::invalid_argument);
}
