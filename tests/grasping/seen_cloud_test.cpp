// Clouds that are prepared before anything is known of what they show.
#include "quadrille/grasping/seen_cloud.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include "grasping/plans.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::vector<Ball> two_balls() {
  return {ball_on_table(-0.06, 0.0, 0.025), ball_on_table(0.06, 0.0, 0.03)};
}

void check_same_plans(const PointCloud& cloud) {
  const std::vector<Ball> balls = two_balls();
  const GraspPlan plan = GraspScene(cloud, detections_of(balls), franka_hand()).plan();
  SeenCloud seen(cloud, PlanOptions());
  CHECK(seen.cloud().points.size() == cloud.points.size());
  const GraspPlan same = GraspScene(std::move(seen), detections_of(balls), franka_hand()).plan();
  check_same_grasps(plan, same);
  CHECK(same.rejected == plan.rejected);
  CHECK(same.warnings == plan.warnings);
  REQUIRE((same.space != nullptr) == (plan.space != nullptr));
  if (plan.space) CHECK(same.space->states() == plan.space->states());
}

}  // namespace

TEST_CASE("a plan on a cloud that was prepared is the same", "[plan][seen_cloud][determinism]") {
  PointCloud cloud = render(two_balls());
  check_same_plans(cloud);
  CHECK_FALSE(plan_balls(two_balls()).grasps.empty());
  // Points that no sensor measures, then no viewpoint, then no points.
  cloud.points.front() = Eigen::Vector3f::Constant(1e30f);
  check_same_plans(cloud);
  cloud.viewpoint.setConstant(std::numeric_limits<double>::quiet_NaN());
  check_same_plans(cloud);
  check_same_plans(PointCloud());
}

TEST_CASE("a cloud that was prepared with another resolution or baseline makes no scene",
          "[plan][seen_cloud]") {
  PlanOptions coarse, narrow;
  coarse.resolution *= 2.0;
  narrow.baseline *= 0.5;
  for (const PlanOptions& other : {coarse, narrow}) {
    CHECK_THROWS_AS(GraspScene(SeenCloud(render(two_balls()), PlanOptions()),
                               detections_of(two_balls()), franka_hand(), other),
                    std::invalid_argument);
  }
  PlanOptions wrong;
  wrong.resolution = -1.0;
  CHECK_THROWS_AS(SeenCloud(render(two_balls()), wrong), std::invalid_argument);
}
