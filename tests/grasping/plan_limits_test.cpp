// What is not planned on, and what is not grasped.
#include <map>
#include <set>
#include <string>
#include <vector>

#include "grasping/plans.hpp"
#include "support/catch.hpp"
#include "support/missing_codes.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a cloud that contradicts its viewpoint is never planned on", "[plan]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  PointCloud cloud = render({ball});
  const std::vector<Detection> detections = {sphere_detection(ball), table_detection()};
  REQUIRE_FALSE(plan_grasps(cloud, detections, franka_hand()).grasps.empty());
  // Below the table, on its far side.
  cloud.viewpoint = table_detection().X_CQ * Eigen::Vector3d(0.1, 0.0, -0.3);
  for (const UnknownPolicy policy : {UnknownPolicy::kObstacle, UnknownPolicy::kFree}) {
    const GraspPlan plan = plan_grasps(cloud, detections, franka_hand(), with(policy));
    CHECK(plan.grasps.empty());
    CHECK(plan.rejected == std::map<std::string, int>{{"viewpoint", 1}});
    REQUIRE(plan.warnings.size() == 1);
    CHECK(plan.warnings[0].find("cannot have been seen from its viewpoint") != std::string::npos);
  }
  // Another view that does is left out, so that the map is that of the first view.
  const GraspPlan alone = plan_grasps(render({ball}), detections, franka_hand());
  const GraspPlan plan =
      plan_grasps(render({ball}), detections, franka_hand(), PlanOptions(), {{cloud}});
  CHECK(plan.space->states() == alone.space->states());
  CHECK(plan.grasps.size() == alone.grasps.size());
  REQUIRE(plan.warnings.size() == alone.warnings.size() + 1);
  CHECK(plan.warnings[0].find("a further view is left out: the cloud cannot") == 0);
}

TEST_CASE("what is targeted never changes what is in the way", "[plan]") {
  const std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03), ball_on_table(0.09, 0.0, 0.03)};
  const PointCloud cloud = render(balls);
  Detection can = cylinder_detection(Eigen::Isometry3d::Identity(), 0.03, 0.06, 2);
  can.X_CQ = table_detection().X_CQ * Eigen::Translation3d(0.09, 0.0, 0.03);
  const std::vector<Detection> detections = {sphere_detection(balls[0]), can, table_detection()};
  GraspPlan all = plan_grasps(cloud, detections, franka_hand());
  REQUIRE(targets_of(all) == std::set<int>{1, 2});
  PlanOptions spheres;
  spheres.targets = {QuadricType::kSphere};
  std::vector<Detection> marked = detections;
  marked[1].id = -1;
  marked[2].id = -2;
  std::erase_if(all.grasps, [](const Grasp& grasp) { return grasp.target != 1; });
  for (const GraspPlan& some : {plan_grasps(cloud, detections, franka_hand(), spheres),
                                plan_grasps(cloud, marked, franka_hand())}) {
    check_same_grasps(some, all);
    CHECK(some.shapes.size() == all.shapes.size());
  }
}

TEST_CASE("targets far apart are mapped more coarsely, with a warning", "[plan]") {
  Detection near = sphere_detection({{0, 0, 0.7}, 0.03}, 1);
  Detection far = sphere_detection({{3, 2, 3}, 0.03}, 2);
  const GraspPlan plan = plan_grasps(render(std::vector<Ball>{}), {near, far}, franka_hand());
  CHECK(plan.space->resolution() > PlanOptions().resolution);
  CHECK(plan.rejected.count("far") == 0);
  REQUIRE(plan.warnings.size() == 1);
  const std::string& said = plan.warnings[0];
  const std::string start = "the targets lie far apart: occupancy is mapped at ";
  REQUIRE(said.starts_with(start));
  CHECK(std::stod(said.substr(start.size())) ==
        Approx(1000.0 * plan.space->resolution()).epsilon(0.005));
  CHECK(said.ends_with(" mm in place of 5 mm; crop the cloud for a finer map"));
}

TEST_CASE("bodies far off are refused, and cost neither memory nor the others' grasps",
          "[plan][hostile]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  const std::vector<Detection> near = {sphere_detection(ball), table_detection()};
  const GraspPlan alone = plan_grasps(render({ball}), near, franka_hand());
  REQUIRE_FALSE(alone.grasps.empty());
  std::vector<Detection> all = near;
  all.push_back(sphere_detection({{1e4, 0, 0.7}, 0.03}, 2));
  all.push_back(sphere_detection({{0, 0, 1e4}, 0.03}, 3));
  const GraspPlan plan = plan_grasps(render({ball}), all, franka_hand());
  CHECK(plan.rejected.at("far") == 2);
  CHECK(plan.space->states().size() == alone.space->states().size());
  check_same_grasps(plan, alone);
}

TEST_CASE("pixels with codes for missing ones change no grasp and no voxel", "[plan][hostile]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  const std::vector<Detection> detections = {sphere_detection(ball), table_detection()};
  const PointCloud cloud = render({ball}), holed = with_gaps(cloud);
  const GraspPlan truth = plan_grasps(holed, detections, franka_hand(), PlanOptions(), {{holed}});
  REQUIRE_FALSE(truth.grasps.empty());
  CHECK(truth.warnings.empty());
  for (const float code : kMissingCodes) {
    CAPTURE(code);
    const PointCloud coded = with_code(cloud, code);
    const GraspPlan plan = plan_grasps(coded, detections, franka_hand(), PlanOptions(), {{coded}});
    CHECK(plan.space->states() == truth.space->states());
    CHECK(plan.warnings.size() == (std::isfinite(code) ? 2 : 0));
    check_same_grasps(plan, truth);
  }
}
