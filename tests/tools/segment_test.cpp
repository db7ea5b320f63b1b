#include "lab/scene/segment.hpp"

#include <algorithm>

#include "base/random.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::scene {
namespace {

TEST_CASE("segments that cross, run side by side, follow each other or are points",
          "[scene][segment]") {
  const Segment x{{-1, 0, 0}, {1, 0, 0}};
  CHECK(distance(x, {{0, -1, 0.5}, {0, 1, 0.5}}) == Approx(0.5));
  CHECK(distance(x, {{-3, 2, 0}, {3, 2, 0}}) == Approx(2.0));
  CHECK(distance(x, {{4, 0, 0}, {2, 0, 0}}) == Approx(1.0));
  CHECK(distance(x, {{-3, 0, 4}, {-4, 0, 4}}) == Approx(std::hypot(2.0, 4.0)));
  CHECK(distance(x, {{4, 4, 0}, {4, 4, 0}}) == Approx(5.0));
  CHECK(distance({{1, 1, 1}, {1, 1, 1}}, {{1, 1, 3}, {1, 1, 3}}) == Approx(2.0));
  CHECK(distance(x, x) == 0.0);
}

TEST_CASE("the distance of two segments is the least of their points' in either order",
          "[scene][segment]") {
  RandomStream random(9, 0);
  const auto point = [&] {
    const double x = test::gaussian(random), y = test::gaussian(random);
    return Eigen::Vector3d(x, y, test::gaussian(random));
  };
  constexpr int kSteps = 200;
  for (int trial = 0; trial < 50; ++trial) {
    Segment s{point(), point()}, t{point(), point()};
    if (trial % 5 == 0) t.b = t.a + 0.3 * (s.b - s.a);
    double least = 1e9;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const Eigen::Vector3d a = s.a + (s.b - s.a) * i / kSteps,
                              b = t.a + (t.b - t.a) * j / kSteps;
        least = std::min(least, (a - b).norm());
      }
    }
    CAPTURE(trial);
    CHECK(distance(s, t) <= least + 1e-12);
    CHECK(distance(s, t) > least - 0.02);
    CHECK(distance(t, s) == Approx(distance(s, t)).margin(1e-12));
  }
}

}  // namespace
}  // namespace quadrille::scene
