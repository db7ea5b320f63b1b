#include "targets/target_points.hpp"

#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

Target solid_ball(const Ball& ball) {
  Target target;
  target.body = make_body(sphere_detection(ball)).value();
  return target;
}

/// Points of the target on the side of a ball that faces the camera.
TargetPoints points_on(const Ball& ball) {
  TargetPoints points;
  for (int n = 0; n < 400; ++n) {
    const Eigen::Vector3d d(0.04 * (n % 20 - 10), 0.04 * (n / 20.0 - 10), -1.0);
    points.all.p_C.push_back(ball.p_C + ball.radius * d.normalized());
  }
  points.own.assign(points.all.p_C.size(), 1);
  return points;
}

}  // namespace

TEST_CASE("a ball wider than the hand opens has no points to hold, unless a handle stands out",
          "[points][target]") {
  const Ball wide{Eigen::Vector3d(0.0, 0.0, 0.7), 0.05};
  TargetPoints points = points_on(wide);
  CHECK(all_too_wide(solid_ball(wide), points, franka_hand()));
  Gripper wider = franka_hand();
  wider.max_opening = 0.11;
  CHECK_FALSE(all_too_wide(solid_ball(wide), points, wider));
  for (int n = 0; n < 20; ++n) {
    points.all.p_C.emplace_back(wide.p_C + Eigen::Vector3d(0.065 + 0.001 * n, 0.0, 0.0));
    points.own.push_back(1);
  }
  CHECK_FALSE(all_too_wide(solid_ball(wide), points, franka_hand()));
}

TEST_CASE("neither slim solids nor bodies without a shape are too wide", "[points][target]") {
  const Ball slim{Eigen::Vector3d(0.0, 0.0, 0.7), 0.03}, wide{slim.p_C, 0.05};
  CHECK_FALSE(all_too_wide(solid_ball(slim), points_on(slim), franka_hand()));
  Target lump = solid_ball(wide);
  lump.solid = false;
  CHECK_FALSE(all_too_wide(lump, points_on(wide), franka_hand()));
}
