// How wide the hand opens on its way to a target, through plan_grasps().
#include <algorithm>
#include <cmath>
#include <vector>

#include "grasping/plans.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

// A little less than the hand opens on either side beyond what it needs, if nothing is near [m].
constexpr double kWide = 0.0199;
constexpr double kRadius = 0.012;

bool is_wide(const Grasp& grasp) { return grasp.preshape > grasp.width + 2.0 * kWide; }

/// The grasps on the first ball that close along x of the table.
std::vector<Grasp> across_x(const std::vector<Ball>& balls) {
  PlanOptions options = with(UnknownPolicy::kFree);
  options.min_score = 0.0;
  std::vector<Grasp> grasps = plan_balls(balls, options).grasps;
  std::erase_if(grasps, [](const Grasp& grasp) {
    return grasp.target != 1 || std::abs(grasp.X_CG.linear()(0, 1)) < 0.9;
  });
  return grasps;
}

}  // namespace

TEST_CASE("a hand opens wide where nothing is near", "[plan][openings]") {
  const std::vector<Grasp> grasps = across_x({ball_on_table(0.0, 0.0, kRadius)});
  REQUIRE_FALSE(grasps.empty());
  int across_middle = 0;
  for (const Grasp& grasp : grasps) {
    // Holds beside the middle of the ball are left out, since the hand may open less there.
    if (grasp.width < 2.0 * kRadius - 1e-6) continue;
    CHECK(is_wide(grasp));
    ++across_middle;
  }
  CHECK(across_middle > 2);
}

TEST_CASE("a hand opens less wide where neighbours stand close", "[plan][openings]") {
  // Between the balls there is room for a finger and 12 mm.
  const double aside = 2.0 * kRadius + franka_hand().finger.y() + 0.012;
  const std::vector<Grasp> grasps =
      across_x({ball_on_table(0.0, 0.0, kRadius), ball_on_table(aside, 0.0, kRadius),
                ball_on_table(-aside, 0.0, kRadius)});
  REQUIRE_FALSE(grasps.empty());
  CHECK(std::none_of(grasps.begin(), grasps.end(), is_wide));
}

TEST_CASE("a hold that is refused counts once, however many openings were tried",
          "[plan][openings]") {
  const Ball ball = ball_on_table(0.0, 0.0, kRadius);
  const auto refused = [&](const GraspQuery& query) {
    const GraspPlan plan = plan_grasps(render({ball}), detections_of({ball}), franka_hand(),
                                       with(UnknownPolicy::kFree), {}, query);
    CHECK(plan.grasps.empty());
    int all = 0;
    for (const auto& [why, count] : plan.rejected) all += count;
    return all;
  };
  GraspQuery nothing_wanted, clear;
  // The caller is asked once for each hold, as it refuses the first opening.
  int asked = 0;
  nothing_wanted.accept = [&](const Grasp&) { return ++asked < 0; };
  // The table is nearer to each hand, however wide it opens.
  clear.min_clearance = 0.03;
  const int once = refused(nothing_wanted);
  REQUIRE(asked > 10);
  CHECK(refused(clear) == once);
}
