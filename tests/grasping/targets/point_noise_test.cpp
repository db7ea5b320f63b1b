// The spread of points about a surface, against points drawn with a known one.
#include "targets/point_noise.hpp"

#include <random>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Points of a ball's upper half with normal noise along its normals.
PointCloud noisy(const Ball& ball, double sigma, int count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  PointCloud cloud;
  while (static_cast<int>(cloud.points.size()) < count) {
    Eigen::Vector3d n(normal(random), normal(random), normal(random));
    n.normalize();
    const Eigen::Vector3d p = ball.p_C + (ball.radius + sigma * normal(random)) * n;
    cloud.points.push_back(p.cast<float>());
  }
  return cloud;
}

}  // namespace

TEST_CASE("the noise of a target's points is measured", "[target][point_noise]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  for (const double sigma : {0.0003, 0.001, 0.003}) {
    PointCloud cloud = noisy(ball, sigma, 90000);
    CHECK(point_noise(sphere_detection(ball), cloud) == Approx(sigma).epsilon(0.05));
    // What lies farther off, and missing points, do not count.
    for (int n = 0; n < 200000; ++n) {
      cloud.points.emplace_back(0.5f, 0.1f, 1.0f);
      cloud.points.emplace_back(Eigen::Vector3f::Constant(std::nanf("")));
    }
    CHECK(point_noise(sphere_detection(ball), cloud) == Approx(sigma).epsilon(0.1));
  }
}

TEST_CASE("a target without points has no noise", "[target][point_noise]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  CHECK(point_noise(sphere_detection(ball), PointCloud()) == 0.0);
}
