// No hand goes below a support that is known.
#include <algorithm>
#include <vector>

#include "grasping/known_scene.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("no hand goes below a support that is known, though nobody saw it",
          "[surroundings][support]") {
  CanScene scene;
  scene.with_table = false;
  const std::vector<Grasp> free = all_hands(scene, {});
  const auto below = [&](const Grasp& grasp) { return lowest_corner(grasp, scene) < -0.001; };
  REQUIRE(std::count_if(free.begin(), free.end(), below) > 10);
  Surroundings known;
  KnownSupport support;
  support.n_C = scene.X_CW.linear().col(2);
  support.offset = support.n_C.dot(scene.X_CW.translation());
  known.support = support;
  const std::vector<Grasp> kept = all_hands(scene, known);
  CHECK_FALSE(kept.empty());
  CHECK(std::none_of(kept.begin(), kept.end(), below));
  const GraspPlan plan = plan_scene(scene, known);
  REQUIRE_FALSE(plan.grasps.empty());
  CHECK(std::none_of(plan.grasps.begin(), plan.grasps.end(), below));
  // The support is nothing to hold, and no shape of the plan.
  for (const Grasp& grasp : plan.grasps) CHECK(grasp.target == 1);
  CHECK(plan.shapes.size() == plan_scene(scene, {}).shapes.size());
}
