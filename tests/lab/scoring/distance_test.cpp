#include "lab/scoring/distance.hpp"

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::scoring {
namespace {

using test::ball_at;
using test::kBallRadius;

TrueSurface ball() {
  TrueSurface surface;
  surface.Q_C = ball_at(0, kBallRadius);
  surface.size = 2.0 * kBallRadius;
  return surface;
}

/// Points in front of the ball's surface by a distance, on its side towards the camera.
std::vector<Eigen::Vector3f> points_before(float distance) {
  const float radius = static_cast<float>(kBallRadius) + distance;
  std::vector<Eigen::Vector3f> points;
  for (const float x : {-0.5f, 0.0f, 0.3f}) {
    const Eigen::Vector3f ray = Eigen::Vector3f(x, 0.2f, -1.0f).normalized();
    points.push_back(Eigen::Vector3f(0, 0, 1) + radius * ray);
  }
  return points;
}

TEST_CASE("the distance is that from the nearest finding, without the noise of the points",
          "[scoring][distance]") {
  const Found far{ball_at(0, 0.08), 1.0}, near{ball_at(0, 0.103), 1.0};
  for (const float noise : {0.0f, 0.004f}) {
    CHECK(least_distance(ball(), points_before(noise), {far, near}) == Approx(0.003).epsilon(0.02));
  }
}

TEST_CASE("a superquadric has distances as the quadric has that it equals", "[scoring][distance]") {
  Superquadric S;
  S.axes.setConstant(0.102);
  S.X_CS.translation() << 0, 0, 1;
  const Found found{Quadric(), 1.0, S};
  CHECK(least_distance(ball(), points_before(0.0f), {found}) == Approx(0.002).epsilon(1e-3));
}

TEST_CASE("no distance is larger than the surface", "[scoring][distance][degenerate]") {
  CHECK(least_distance(ball(), points_before(0.0f), {}) == Approx(2.0 * kBallRadius));
  CHECK(least_distance(ball(), points_before(0.0f), {{test::wall_at(9.0), 1.0}}) ==
        Approx(2.0 * kBallRadius));
  // A constant has no surface and no gradient.
  Eigen::Matrix4d one = Eigen::Matrix4d::Zero();
  one(3, 3) = 1.0;
  CHECK(least_distance(ball(), points_before(0.0f), {{Quadric(one), 1.0}}) ==
        Approx(2.0 * kBallRadius));
}

}  // namespace
}  // namespace quadrille::scoring
