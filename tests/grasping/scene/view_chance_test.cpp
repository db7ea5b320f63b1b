// Tests of how likely a further view gives a body a grasp, for plans whose refusals are set by
// hand.
#include "scene/view_chance.hpp"

#include <Eigen/Core>
#include <limits>
#include <numbers>

#include "quadrille/grasping/gripper.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

constexpr double kOpen = std::numeric_limits<double>::infinity();
const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

/// A can that stands upright, and of which both radii are known as well.
SceneBody can_of(double diameter, double std) {
  SceneBody body;
  body.id = 3;
  body.parts = {3, 4};
  body.size = {diameter, diameter, 0.03};
  body.std = {std, std, kOpen};
  return body;
}

/// A plan that refused the candidates of one part of that can.
GraspPlan refused_by(Refusal why) {
  GraspPlan plan;
  plan.targets = {{4, 0, {{Refusal::kWidth, 9}, {why, 1}}}};
  return plan;
}

GraspPlan with_score(double score) {
  GraspPlan plan;
  Grasp grasp;
  grasp.contacts_C = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  grasp.target = 4;
  grasp.score = score;
  plan.grasps = {grasp};
  return plan;
}

Prospect prospect_of(const SceneBody& body, const GraspPlan& plan) {
  return prospect_of(body, plan, franka_hand(), {}, kUp);
}

}  // namespace

TEST_CASE("a body may fit into the hand if it does so two standard deviations smaller",
          "[looks][chance]") {
  // The hand opens by 80 mm, of which each pad keeps 2.5 mm free.
  const auto fits = [](double diameter, double std) {
    return may_fit(can_of(diameter, std), franka_hand(), {}, kUp);
  };
  CHECK(fits(0.0749, 0.0));
  CHECK_FALSE(fits(0.0751, 0.0));
  CHECK(fits(0.0849, 0.005));
  CHECK_FALSE(fits(0.0851, 0.005));
  CHECK(fits(0.3, kOpen));
}

TEST_CASE("the height of a standing body does not let the hand close on it", "[looks][chance]") {
  SceneBody body = can_of(0.12, 0.001);
  body.size.z() = 0.03;
  body.std.z() = 0.001;
  CHECK_FALSE(may_fit(body, franka_hand(), {}, kUp));
  // Once it lies, its height is a side of it.
  CHECK(may_fit(body, franka_hand(), {}, Eigen::Vector3d::UnitX()));
  // Nobody knows where up is, so that the hand may close along any axis.
  CHECK(may_fit(body, franka_hand(), {}, Eigen::Vector3d::Zero()));
}

TEST_CASE("a view helps where hands met things, less if the body seems too wide",
          "[looks][chance]") {
  for (const Refusal why : {Refusal::kContradicted, Refusal::kTarget, Refusal::kCollision}) {
    const double slim = prospect_of(can_of(0.06, 0.002), refused_by(why)).chance;
    const double wide = prospect_of(can_of(0.11, 0.002), refused_by(why)).chance;
    CHECK(slim > 0.5);
    CHECK(wide < 0.5);
    CHECK(wide > 0.0);
  }
  // Hands that met nothing but unknown space fit.
  CHECK(prospect_of(can_of(0.11, 0.002), refused_by(Refusal::kUnknown)).chance > 0.5);
}

TEST_CASE("a view helps less where the support is in the way of most hands", "[looks][chance]") {
  const SceneBody can = can_of(0.06, 0.002);
  GraspPlan plan = refused_by(Refusal::kCollision);
  plan.targets[0].refusals = {
      {Refusal::kSupport, 5}, {Refusal::kTarget, 2}, {Refusal::kCollision, 3}};
  CHECK(prospect_of(can, plan).chance > 0.5);
  // All parts of a body count together, those of others do not.
  plan.targets.push_back({9, 0, {{Refusal::kSupport, 1}}});
  CHECK(prospect_of(can, plan).chance > 0.5);
  plan.targets.back().target = 3;
  CHECK(prospect_of(can, plan).chance < 0.5);
}

TEST_CASE("no view is likely to mend a low score, and none mends what the hand cannot do",
          "[looks][chance]") {
  const SceneBody can = can_of(0.06, 0.002);
  CHECK(prospect_of(can, refused_by(Refusal::kScore)).chance < 0.5);
  CHECK(prospect_of(can, refused_by(Refusal::kSupport)).chance < 0.5);
  for (const Refusal why : {Refusal::kWidth, Refusal::kReach, Refusal::kCaller}) {
    CHECK(prospect_of(can, refused_by(why)).chance == 0.0);
  }
  CHECK(prospect_of(can, GraspPlan{}).chance == 0.0);
}

TEST_CASE("a sure grasp needs no view, and a nearly sure one is the likeliest to become sure",
          "[looks][chance]") {
  const SceneBody can = can_of(0.06, 0.002);
  CHECK(prospect_of(can, with_score(0.9)).chance == 0.0);
  const Prospect nearly = prospect_of(can, with_score(0.89)),
                 poor = prospect_of(can, with_score(0.5));
  CHECK(nearly.has_grasp);
  CHECK(poor.has_grasp);
  CHECK(nearly.chance > poor.chance);
  CHECK(poor.chance > 0.0);
  // The grasps of others do not count.
  SceneBody other = can;
  other.id = 7;
  other.parts = {7};
  CHECK(prospect_of(other, with_score(0.9)).chance == 0.0);
  CHECK_FALSE(prospect_of(other, with_score(0.9)).has_grasp);
}

TEST_CASE("a view is worth more the more it shows, the farther aside and the higher it is",
          "[looks][chance]") {
  const Prospect prospect{0.8, false};
  const double right = std::numbers::pi / 2.0;
  const auto chance = [&](double share, double angle, double height) {
    return chance_by_view(prospect, share, angle, height);
  };
  CHECK(chance(0.4, right, 0.5) > chance(0.2, right, 0.5));
  CHECK(chance(0.4, 0.9, 0.5) > chance(0.4, 0.5, 0.5));
  CHECK(chance(0.4, right, 0.5) > chance(0.4, right, 0.2));
  // A half of the unknown space, 60° aside and 40° above the support are enough.
  CHECK(chance(0.5, right, 1.0) == chance(1.0, 3.0, 0.7));
  // No view is as good as the best of many.
  CHECK(chance(1.0, right, 1.0) < prospect.chance);
  CHECK(chance(1.0, right, 1.0) > 0.7 * prospect.chance);
  CHECK(chance_by_view({0.8, true}, 1.0, right, 1.0) < chance(1.0, right, 1.0));
  CHECK(chance_by_view({}, 1.0, right, 1.0) == 0.0);
}
