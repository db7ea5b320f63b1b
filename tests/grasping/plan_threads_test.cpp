// Plans on several threads: the same bits as on one.
#include <stdexcept>
#include <thread>
#include <vector>

#include "grasping/plans.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::vector<Ball> five_balls() {
  std::vector<Ball> balls;
  balls.reserve(5);
  for (int k = 0; k < 5; ++k) balls.push_back(ball_on_table(0.1 * k - 0.2, 0.0, 0.02 + 0.004 * k));
  return balls;
}

PlanOptions on_threads(int threads) {
  PlanOptions options;
  options.threads = threads;
  return options;
}

}  // namespace

TEST_CASE("the number of threads never changes a plan", "[plan][threads][determinism]") {
  const GraspPlan one = plan_balls(five_balls(), on_threads(1));
  CHECK(targets_of(one).size() == 5);
  for (const int threads : {2, 3, 16}) {
    const GraspPlan several = plan_balls(five_balls(), on_threads(threads));
    check_same_grasps(one, several);
    CHECK(several.rejected == one.rejected);
    CHECK(several.space->states() == one.space->states());
    REQUIRE(several.targets.size() == one.targets.size());
    for (std::size_t k = 0; k < one.targets.size(); ++k) {
      CHECK(several.targets[k].target == one.targets[k].target);
      CHECK(several.targets[k].grasps == one.targets[k].grasps);
      CHECK(several.targets[k].refusals == one.targets[k].refusals);
    }
  }
}

TEST_CASE("the caller's own condition is asked by the caller's own thread", "[plan][threads]") {
  const std::vector<Ball> balls = five_balls();
  const GraspScene scene(render(balls), detections_of(balls), franka_hand(), on_threads(4));
  GraspQuery query;
  bool asked = false, by_another = false;
  query.accept = [&, caller = std::this_thread::get_id()](const Grasp&) {
    asked = true;
    by_another |= std::this_thread::get_id() != caller;
    return true;
  };
  CHECK_FALSE(scene.plan(query).grasps.empty());
  CHECK(asked);
  CHECK_FALSE(by_another);
}

TEST_CASE("the search ends at once when the caller's own condition throws", "[plan][threads]") {
  const std::vector<Ball> balls = five_balls();
  const GraspScene scene(render(balls), detections_of(balls), franka_hand(), on_threads(4));
  GraspQuery query;
  int calls = 0;
  query.accept = [&](const Grasp&) -> bool {
    ++calls;
    throw std::domain_error("the arm is off");
  };
  CHECK_THROWS_AS(scene.plan(query), std::domain_error);
  CHECK(calls == 1);
}
