#include "grasping/plans.hpp"
#include "quadrille/detector/known_detection.hpp"

namespace quadrille::test {
namespace {

TEST_CASE("grasps are planned on a ball that the caller knows as on a detected one", "[plan]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  std::vector<Detection> known = {
      table_detection(),
      known_detection(QuadricType::kSphere, Eigen::Isometry3d(Eigen::Translation3d(ball.p_C)),
                      {{"radius", ball.radius}})};
  known[1].id = 2;
  const GraspPlan plan = plan_grasps(render({ball}), known, franka_hand());
  REQUIRE(targets_of(plan) == std::set<int>{2});
  CHECK(plan.grasps.front().score > 0.5);
  for (const Grasp& grasp : plan.grasps) {
    CHECK(grasp.width < 2.0 * ball.radius + 1e-9);
  }
}

TEST_CASE("grasps are planned on a box that the caller knows", "[plan]") {
  PointCloud cloud;  // far beside it
  for (int i = 0; i < 50; ++i) cloud.points.emplace_back(3.0f, 0.01f * i, 3.0f);
  Box box = known_box(Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.8)), {0.08, 0.05, 0.04});
  box.id = 1;
  const GraspPlan plan = plan_grasps(cloud, {}, franka_hand(), with(UnknownPolicy::kFree), {}, {},
                                     std::vector<Box>{box});
  CHECK(targets_of(plan) == std::set<int>{1});
}

}  // namespace
}  // namespace quadrille::test
