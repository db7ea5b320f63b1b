// The outcome that a plan tells of each target, and the changes that give grasps to targets
// without.
#include "quadrille/grasping/remedies.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "grasping/plans.hpp"
#include "quadrille/grasping/grasp_scene.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

struct Asked {
  std::vector<Ball> balls;
  PlanOptions options = {};
  GraspQuery query = {};

  GraspPlan plan(const Gripper& gripper = franka_hand()) const {
    return GraspScene(render(balls), detections_of(balls), gripper, options).plan(query);
  }
  std::vector<Remedy> remedies() const {
    return find_remedies(plan(), render(balls), detections_of(balls), franka_hand(), options, {},
                         query);
  }
};

const TargetOutcome& outcome_of(const GraspPlan& plan, int target) {
  const auto found =
      std::find_if(plan.targets.begin(), plan.targets.end(),
                   [&](const TargetOutcome& outcome) { return outcome.target == target; });
  REQUIRE(found != plan.targets.end());
  return *found;
}

/// The remedy for a target whose change begins with these words.
const Remedy* find(const std::vector<Remedy>& remedies, int target, const std::string& change) {
  const auto found = std::find_if(remedies.begin(), remedies.end(), [&](const Remedy& remedy) {
    return remedy.target == target && remedy.change.starts_with(change);
  });
  return found == remedies.end() ? nullptr : &*found;
}

/// The Franka Hand opens 80 mm: it holds the first ball, but not the second.
Asked small_and_large() {
  return {{ball_on_table(-0.15, 0.0, 0.03), ball_on_table(0.12, 0.0, 0.045)}};
}

}  // namespace

TEST_CASE("a plan tells what became of each target", "[plan][remedies]") {
  const Asked asked = small_and_large();
  const GraspPlan plan = asked.plan();
  CHECK(plan.targets.size() == 2);
  const TargetOutcome &small = outcome_of(plan, 1), &large = outcome_of(plan, 2);
  CHECK(small.grasps == std::count_if(plan.grasps.begin(), plan.grasps.end(),
                                      [](const Grasp& grasp) { return grasp.target == 1; }));
  CHECK(small.grasps > 0);
  CHECK(large.grasps == 0);
  REQUIRE(furthest(large.refusals));
  // Together they are what was refused of all.
  std::map<std::string, int> sums;
  for (const TargetOutcome& outcome : plan.targets) {
    for (const auto& [why, count] : outcome.refusals) sums[std::string(to_string(why))] += count;
  }
  for (const auto& [why, count] : sums) {
    CAPTURE(why);
    CHECK(plan.rejected.at(why) == count);
  }
}

TEST_CASE("only targets that were asked for have an outcome", "[plan][remedies]") {
  Asked asked = small_and_large();
  asked.query.ids = {2};
  const GraspPlan plan = asked.plan();
  REQUIRE(plan.targets.size() == 1);
  CHECK(plan.targets[0].target == 2);
  CHECK(plan.targets[0].grasps == 0);
}

TEST_CASE("a target that is refused by its shape and held by its points has one outcome",
          "[plan][remedies]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  // The detector takes the ball for one that is too large for the hand, of which few points remain.
  Detection large = sphere_detection({ball.p_C, 0.08}, 1);
  SceneBody body;
  body.id = 1;
  body.X_CB.linear() = table_detection().X_CQ.linear();
  body.X_CB.translation() = ball.p_C;
  body.size.setConstant(2.0 * ball.radius);
  PlanOptions options = with(UnknownPolicy::kFree);
  options.min_score = 0.0;
  const GraspPlan plan = plan_grasps(render({ball}), {table_detection(), large}, franka_hand(),
                                     options, {}, {}, {}, {body});
  REQUIRE(plan.targets.size() == 1);
  CHECK(plan.targets[0].target == 1);
  CHECK(plan.targets[0].grasps > 0);
  CHECK(plan.targets[0].refusals.at(Refusal::kWidth) >= 1);
}

TEST_CASE("what is not to be grasped has no outcome", "[plan][remedies]") {
  Asked asked = small_and_large();
  asked.options.max_detections = 1;
  asked.options.targets = {QuadricType::kCylinder};
  CHECK(asked.plan().targets.empty());
}

TEST_CASE("a hand that opens wider is a remedy for what is too wide", "[plan][remedies]") {
  const std::vector<Remedy> remedies = small_and_large().remedies();
  for (const Remedy& remedy : remedies) CHECK(remedy.target == 2);
  const Remedy* wider = find(remedies, 2, "--gripper robotiq_2f140");
  REQUIRE(wider != nullptr);
  // It is what the plan for that hand says.
  const GraspPlan plan = small_and_large().plan(robotiq_2f140());
  CHECK(outcome_of(plan, 2).grasps == wider->grasps);
  double best = 0.0;
  for (const Grasp& grasp : plan.grasps) {
    if (grasp.target == 2) best = std::max(best, grasp.score);
  }
  CHECK(wider->score == best);
}

TEST_CASE("the condition that excludes all grasps is the one to leave out", "[plan][remedies]") {
  Asked asked{{ball_on_table(-0.15, 0.0, 0.03)}};
  SECTION("an approach from below") {
    asked.query.approach = Cone{table_detection().X_CQ.linear().col(2), 0.3};
    const std::vector<Remedy> remedies = asked.remedies();
    CHECK(find(remedies, 1, "without --approach") != nullptr);
    CHECK(find(remedies, 1, "--gripper") == nullptr);
  }
  SECTION("a base that is too far") {
    asked.query.reach = Reach{Eigen::Vector3d(5.0, 0.0, 0.0), 0.0, 0.8};
    const std::vector<Remedy> remedies = asked.remedies();
    CHECK(find(remedies, 1, "without --reach") != nullptr);
    CHECK(find(remedies, 1, "--gripper") == nullptr);
  }
  SECTION("a score that nothing reaches") {
    asked.query.min_score = 1.0;
    const std::vector<Remedy> remedies = asked.remedies();
    const Remedy* lower = find(remedies, 1, "--min-score");
    REQUIRE(lower != nullptr);
    asked.query.min_score = std::stod(lower->change.substr(std::string("--min-score ").size()));
    CHECK(outcome_of(asked.plan(), 1).grasps == lower->grasps);
  }
}

TEST_CASE("there are no remedies if every target has grasps", "[plan][remedies]") {
  const Asked asked{{ball_on_table(0.0, 0.0, 0.03)}};
  REQUIRE(outcome_of(asked.plan(), 1).grasps > 0);
  CHECK(asked.remedies().empty());
}
