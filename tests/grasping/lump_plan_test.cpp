// Plans on bodies without a known shape, through plan_grasps().
#include <algorithm>
#include <cmath>

#include "grasping/plans.hpp"
#include "hand/hand.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// The ball as a body of which only the box around it is known.
SceneBody lump_of(const Ball& ball, int id = 7) {
  SceneBody body;
  body.id = id;
  body.kind = BodyKind::kLump;
  body.X_CB.linear() = table_detection().X_CQ.linear();
  body.X_CB.translation() = ball.p_C;
  body.size.setConstant(2.0 * ball.radius);
  body.standing_on = table_detection().id;
  return body;
}

GraspPlan plan_lumps(const std::vector<Ball>& balls, const std::vector<SceneBody>& bodies,
                     const PlanOptions& options) {
  return plan_grasps(render(balls), {table_detection()}, franka_hand(), options, {}, {}, {},
                     bodies);
}

PlanOptions all_of(UnknownPolicy policy) {
  PlanOptions options = with(policy);
  options.min_score = 0.0;
  return options;
}

}  // namespace

TEST_CASE("a body without a shape is held between its outermost points", "[plan][points]") {
  const Ball ball = ball_on_table(0.02, 0.01, 0.03);
  for (const UnknownPolicy policy : {UnknownPolicy::kObstacle, UnknownPolicy::kFree}) {
    const GraspPlan plan = plan_lumps({ball}, {lump_of(ball)}, all_of(policy));
    REQUIRE_FALSE(plan.grasps.empty());
    for (const Grasp& grasp : plan.grasps) {
      CHECK(grasp.target == 7);
      CHECK(grasp.terms.shape == 0.0);
      CHECK(grasp.width <= 2.0 * ball.radius + 1e-3);
      CHECK(grasp.preshape > grasp.width);
      // Contacts lie on the ball, to within the thinning of the points.
      for (const Eigen::Vector3d& contact : grasp.contacts_C) {
        CHECK((contact - ball.p_C).norm() == Approx(ball.radius).margin(0.004));
      }
      // The opened fingers touch no part of the ball that was seen.
      const SweptHand hand =
          sweep_hand(franka_hand(), grasp.X_CG, grasp.preshape, grasp.width, grasp.approach);
      for (const Eigen::Vector3d& p : skin(ball)) {
        if ((p - ball.p_C).dot(p) > 0.0) continue;
        CHECK_FALSE(hand.fingers[0].contains(p));
        CHECK_FALSE(hand.fingers[1].contains(p));
        CHECK_FALSE(hand.palm.contains(p));
      }
    }
  }
}

TEST_CASE("without its body what has no shape is no target", "[plan][points]") {
  const Ball ball = ball_on_table(0.02, 0.01, 0.03);
  CHECK(plan_lumps({ball}, {}, all_of(UnknownPolicy::kFree)).grasps.empty());
}

TEST_CASE("a body whose quadric is a target is no second target", "[plan][points]") {
  const Ball ball = ball_on_table(0.02, 0.01, 0.03);
  SceneBody body = lump_of(ball, 1);
  body.kind = BodyKind::kSingle;
  body.parts = {1};
  const GraspPlan with_body = plan_grasps(render({ball}), detections_of({ball}), franka_hand(),
                                          all_of(UnknownPolicy::kObstacle), {}, {}, {}, {body});
  check_same_grasps(with_body, plan_balls({ball}, all_of(UnknownPolicy::kObstacle)));
}

TEST_CASE("a grasp that is less likely to succeed than asked for is refused and counted",
          "[plan][points]") {
  const Ball ball = ball_on_table(0.02, 0.01, 0.03);
  PlanOptions strict = with(UnknownPolicy::kFree);
  strict.min_score = 1.0;
  const GraspPlan none = plan_lumps({ball}, {lump_of(ball)}, strict);
  CHECK(none.grasps.empty());
  CHECK(none.rejected.at("score") > 0);
  strict.min_score = 0.3;
  for (const Grasp& grasp : plan_lumps({ball}, {lump_of(ball)}, strict).grasps) {
    CHECK(grasp.score >= 0.3);
  }
}

TEST_CASE("points too far away for a likely hold are not searched, and the plan says so",
          "[plan][points]") {
  Ball far = ball_on_table(0.0, 0.0, 0.03);
  far.p_C *= 2.0 / far.p_C.norm();
  PlanOptions options = with(UnknownPolicy::kFree);
  options.min_score = 0.6;
  const GraspPlan none = plan_lumps({far}, {lump_of(far)}, options);
  CHECK(none.grasps.empty());
  REQUIRE(none.targets.size() == 1);
  CHECK(none.targets[0].refusals == RefusalCounts{{Refusal::kScore, 1}});
  options.min_score = 0.0;
  CHECK_FALSE(plan_lumps({far}, {lump_of(far)}, options).targets[0].refusals ==
              RefusalCounts{{Refusal::kScore, 1}});
}

TEST_CASE("a neighbour is an obstacle to a hand that holds a body without a shape",
          "[plan][points]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.025), neighbour = ball_on_table(0.062, 0.0, 0.025);
  const GraspPlan plan =
      plan_lumps({ball, neighbour}, {lump_of(ball)}, all_of(UnknownPolicy::kFree));
  REQUIRE_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps) {
    const SweptHand hand =
        sweep_hand(franka_hand(), grasp.X_CG, grasp.preshape, grasp.width, grasp.approach);
    for (const Eigen::Vector3d& p : skin(neighbour)) {
      // The camera measures no points on hidden sides, nor on what it sees at less than 6°.
      if ((p - neighbour.p_C).normalized().dot(p.normalized()) > -0.1) continue;
      CHECK_FALSE(hand.fingers[0].contains(p));
      CHECK_FALSE(hand.fingers[1].contains(p));
      CHECK_FALSE(hand.palm.contains(p));
    }
  }
}

TEST_CASE("points connected with a target belong to it, if they belong to no other target",
          "[plan][points]") {
  const Ball ball = ball_on_table(0.02, 0.01, 0.03);
  // Of the ball only the top 15 mm are named.
  const Eigen::Vector3d up = table_detection().X_CQ.linear().col(2);
  SceneBody top = lump_of(ball), foot = lump_of(ball, 8);
  top.kind = BodyKind::kSingle;
  top.size.z() = 0.015;
  top.X_CB.translation() += 0.0225 * up;
  foot.size.z() = 0.045;
  foot.X_CB.translation() -= 0.0075 * up;
  // The height above the table of the higher contact, in the grasp that is lowest by it.
  const auto lowest = [&](const GraspPlan& plan) {
    double least = std::numeric_limits<double>::infinity();
    for (const Grasp& grasp : plan.grasps) {
      if (grasp.target != 7) continue;
      double height = 0.0;
      for (const Eigen::Vector3d& p_C : grasp.contacts_C) {
        height = std::max(height, up.dot(p_C - table_detection().X_CQ.translation()));
      }
      least = std::min(least, height);
    }
    return least;
  };
  const PlanOptions options = all_of(UnknownPolicy::kFree);
  const double alone = lowest(plan_lumps({ball}, {top}, options));
  const double beside = lowest(plan_lumps({ball}, {top, foot}, options));
  INFO(alone << " and " << beside);
  // The top begins 45 mm above the table; points up to 5 mm beside it belong to it, and a contact
  // is the mean of all points within 4 mm. Alone, the ball is held at its equator.
  CHECK(alone < 0.0345);
  CHECK(beside > 0.0355);
  // Points beside a lump belong to what touches it.
  top.kind = BodyKind::kLump;
  CHECK(lowest(plan_lumps({ball}, {top}, options)) > 0.0355);
}

TEST_CASE("hostile bodies are no targets and do no harm", "[plan][points]") {
  const Ball ball = ball_on_table(0.02, 0.01, 0.03);
  std::vector<SceneBody> bodies(4, lump_of(ball));
  bodies[0].size.setConstant(std::nan(""));
  bodies[1].size.setConstant(1e9);
  bodies[2].size.setConstant(-1.0);
  bodies[3].X_CB.translation().setConstant(std::numeric_limits<double>::infinity());
  const GraspPlan plan = plan_lumps({ball}, bodies, all_of(UnknownPolicy::kFree));
  CHECK(plan.grasps.empty());
}
