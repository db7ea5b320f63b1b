#include "lab/study/grasp_judge.hpp"

#include <cmath>
#include <numbers>

#include "lab/physics/bodies.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d;
using study::GraspJudge;
using study::Verdict;

namespace {

/// A ball of 25 mm radius that lies on the table z = 0.
physics::TrueScene ball_on_table() {
  physics::TrueScene scene;
  scene.bodies.push_back(test::ball(0.025));
  scene.bodies.back().id = 7;
  scene.bodies.back().X_CS.translation().z() = 0.025;
  return scene;
}

/// From above, at a height over the table.
Grasp from_above(double height) {
  Grasp grasp;
  grasp.X_CG.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  grasp.X_CG.translation().z() = height;
  grasp.width = 0.05;
  grasp.preshape = 0.06;
  grasp.approach = 0.05;
  return grasp;
}

Verdict verdict_of(const physics::TrueScene& scene, const Grasp& grasp, double friction = 0.5) {
  return GraspJudge(scene, franka_hand(), friction).judge(grasp).verdict;
}

}  // namespace

TEST_CASE("a grasp across a free ball is good, and of that ball", "[study]") {
  const physics::TrueScene scene = ball_on_table();
  const study::Judgement judgement = GraspJudge(scene, franka_hand(), 0.5).judge(from_above(0.025));
  CHECK(judgement.verdict == Verdict::kGood);
  REQUIRE(judgement.object != nullptr);
  CHECK(judgement.object->id == 7);
}

TEST_CASE("a hand that enters table, neighbour or target touches", "[study]") {
  physics::TrueScene scene = ball_on_table();
  // The tips are 9 mm before the origin; 2 mm are allowed.
  const double tip = franka_hand().finger_front;
  CHECK(verdict_of(scene, from_above(tip - 0.001)) != Verdict::kTouches);
  CHECK(verdict_of(scene, from_above(tip - 0.003)) == Verdict::kTouches);
  Grasp narrow = from_above(0.025);
  narrow.preshape = 0.04;
  CHECK(verdict_of(scene, narrow) == Verdict::kTouches);
  Grasp wide = from_above(0.025);
  wide.preshape = franka_hand().max_opening + 0.001;
  CHECK(verdict_of(scene, wide) == Verdict::kTouches);
  // In the way of the palm, but only as it comes in.
  scene.bodies.push_back(test::block({0.01, 0.01, 0.01}));
  scene.bodies.back().X_CS.translation() = Vector3d(0, 0.09, 0.16);
  CHECK(verdict_of(scene, from_above(0.025)) == Verdict::kTouches);
  Grasp short_way = from_above(0.025);
  short_way.approach = 0.0;
  scene.bodies.back().X_CS.translation().z() = 0.18;
  CHECK(verdict_of(scene, from_above(0.025)) == Verdict::kTouches);
  CHECK(verdict_of(scene, short_way) == Verdict::kGood);
}

TEST_CASE("pads with nothing, or with two things between them, miss", "[study]") {
  physics::TrueScene scene = ball_on_table();
  CHECK(verdict_of(scene, from_above(0.2)) == Verdict::kMisses);
  scene.bodies.push_back(test::block({0.004, 0.02, 0.004}));
  scene.bodies.back().X_CS.translation() = Vector3d(0.0, 0.0, 0.056);
  Grasp both = from_above(0.048);
  CHECK(verdict_of(scene, both) == Verdict::kMisses);
}

TEST_CASE("a ball held off its middle slips beyond the cone of friction", "[study]") {
  const physics::TrueScene scene = ball_on_table();
  // Pads above the equator: the normal there is inclined by asin(dz / r) at their lower edge.
  const double half = 0.5 * franka_hand().pad.y();
  for (const auto& [incline, expected] :
       {std::pair{15.0, Verdict::kGood}, {40.0, Verdict::kSlips}}) {
    CAPTURE(incline);
    const double rise = 0.025 * std::sin(incline * std::numbers::pi / 180.0);
    CHECK(verdict_of(scene, from_above(0.025 + rise + half)) == expected);
  }
  const double rise = 0.025 * std::sin(40.0 * std::numbers::pi / 180.0);
  CHECK(verdict_of(scene, from_above(0.025 + rise + half), 1.2) == Verdict::kGood);
}
