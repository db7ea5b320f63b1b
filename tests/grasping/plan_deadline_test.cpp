// Plans that may take only so long, and on more than there is time for.
#include <chrono>
#include <string>
#include <vector>

#include "grasping/plans.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

// So short that it has passed before the first target is looked at [ms].
constexpr double kNoTime = 1e-6;

std::vector<Ball> row_of_balls() {
  return {ball_on_table(-0.09, 0.0, 0.03), ball_on_table(0.0, 0.0, 0.03),
          ball_on_table(0.09, 0.0, 0.03)};
}

bool tells_of_cut(const GraspPlan& plan) {
  for (const std::string& warning : plan.warnings) {
    if (warning.find("the deadline cut the plan") == 0) return true;
  }
  return false;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("a plan that is cut midway has the grasps that were found until then",
          "[plan][deadline]") {
  const std::vector<Ball> balls = row_of_balls();
  const PointCloud cloud = render(balls);
  std::vector<Detection> detections = detections_of(balls);
  // More targets than there is time for, beside the others and out of their way.
  for (int n = 0; n < 60; ++n) {
    detections.push_back(sphere_detection(balls[static_cast<std::size_t>(n % 3)]));
    detections.back().id = 100 + n;
    detections.back().score = 0.5;
  }
  // Deadlines that grow until none is cut: those in between cut the plan after some targets.
  int cut_with_grasps = 0;
  for (double ms = 1.0; ms < 1e5; ms *= 1.25) {
    PlanOptions options;
    options.deadline_ms = ms;
    const GraspPlan plan = plan_grasps(cloud, detections, franka_hand(), options);
    CHECK(plan.cut == tells_of_cut(plan));
    CHECK(plan.cut == plan.rejected.contains("deadline"));
    if (!plan.cut) break;
    cut_with_grasps += !plan.grasps.empty();
  }
  CHECK(cut_with_grasps > 0);
}

TEST_CASE("a deadline that does not pass changes nothing", "[plan][deadline]") {
  const std::vector<Ball> balls = row_of_balls();
  const PointCloud cloud = render(balls);
  PlanOptions patient;
  patient.deadline_ms = 1e6;
  const GraspPlan timed = plan_grasps(cloud, detections_of(balls), franka_hand(), patient);
  const GraspPlan plan = plan_grasps(cloud, detections_of(balls), franka_hand());
  REQUIRE(plan.grasps.size() > 3);
  check_same_grasps(timed, plan);
  CHECK(timed.rejected == plan.rejected);
  CHECK_FALSE(tells_of_cut(timed));
}

TEST_CASE("a plan that has no time says which targets it did not try", "[plan][deadline]") {
  const std::vector<Ball> balls = row_of_balls();
  const PointCloud cloud = render(balls);
  PlanOptions hasty;
  hasty.deadline_ms = kNoTime;
  const GraspPlan plan = plan_grasps(cloud, detections_of(balls), franka_hand(), hasty);
  CHECK(plan.grasps.empty());
  CHECK(plan.rejected.at("deadline") == 3);
  CHECK(tells_of_cut(plan));
  CHECK(plan.space == nullptr);
  // A query's own deadline counts for it alone.
  const GraspScene scene(cloud, detections_of(balls), franka_hand());
  GraspQuery query;
  query.deadline_ms = kNoTime;
  CHECK(scene.plan(query).rejected.at("deadline") == 3);
  CHECK_FALSE(tells_of_cut(scene.plan()));
  CHECK_FALSE(scene.plan().grasps.empty());
}

TEST_CASE("a scene that had no time tells whoever asks for one of its targets",
          "[plan][deadline]") {
  const std::vector<Ball> balls = row_of_balls();
  PlanOptions hasty;
  hasty.deadline_ms = kNoTime;
  const GraspScene scene(render(balls), detections_of(balls), franka_hand(), hasty);
  GraspQuery query;
  query.ids = {2};
  query.deadline_ms = 0.0;
  const GraspPlan plan = scene.plan(query);
  CHECK(plan.grasps.empty());
  CHECK(tells_of_cut(plan));
}

TEST_CASE("of too many detections those with the best score are planned on", "[plan][deadline]") {
  const std::vector<Ball> balls = row_of_balls();
  std::vector<Detection> detections = detections_of(balls);
  detections[1].score = 0.2;
  PlanOptions options;
  options.max_detections = 3;
  const GraspPlan plan = plan_grasps(render(balls), detections, franka_hand(), options);
  CHECK(plan.rejected.at("surplus") == 1);
  CHECK(plan.shapes.size() == 3);
  for (const Grasp& grasp : plan.grasps) CHECK(grasp.target != detections[1].id);
  CHECK_FALSE(plan.grasps.empty());
}

TEST_CASE("thousands of detections are answered when the deadline passes", "[plan][deadline]") {
  const std::vector<Ball> balls = row_of_balls();
  const PointCloud cloud = render(balls);
  std::vector<Detection> detections = {table_detection()};
  for (int n = 0; n < 4095; ++n) {
    // Beside each other by less than they measure, as copies of one thing are.
    const Ball ball = ball_on_table(0.09 * (n % 3 - 1) + 1e-5 * n, 0.0, 0.03);
    detections.push_back(sphere_detection(ball));
    detections.back().id = n + 2;
  }
  PlanOptions options;
  options.deadline_ms = 200.0;
  const auto start = std::chrono::steady_clock::now();
  const GraspPlan plan = plan_grasps(cloud, detections, franka_hand(), options);
  // The time that one stage takes comes on top; on a busy machine, and with sanitizers, all is
  // slow.
  CHECK(seconds_since(start) < 5.0);
  CHECK(tells_of_cut(plan));
  CHECK(plan.rejected.at("surplus") == 4096 - options.max_detections);
}
