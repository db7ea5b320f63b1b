// How the planner of one target behaves, through plan_grasps(): what it returns and what it counts.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "grasping/plans.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("no two grasps of a target are alike", "[plan][target]") {
  const GraspPlan plan = plan_balls({ball_on_table(0.0, 0.0, 0.03)}, with(UnknownPolicy::kFree));
  REQUIRE(plan.grasps.size() > 3);
  for (std::size_t i = 0; i < plan.grasps.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Grasp &a = plan.grasps[i], &b = plan.grasps[j];
      const auto middle = [](const Grasp& g) -> Eigen::Vector3d {
        return 0.5 * (g.contacts_C[0] + g.contacts_C[1]);
      };
      const bool near = (middle(a) - middle(b)).norm() < 0.011;
      const bool same_way = a.X_CG.linear().col(2).dot(b.X_CG.linear().col(2)) > 0.95;
      const bool same_pads = std::abs(a.X_CG.linear().col(1).dot(b.X_CG.linear().col(1))) > 0.95;
      CHECK_FALSE((near && same_way && same_pads));
    }
  }
}

TEST_CASE("contacts lie on the target, between the pads, and hold with the friction there is",
          "[plan][target]") {
  const Ball ball = ball_on_table(0.02, 0.01, 0.03);
  PlanOptions options = with(UnknownPolicy::kFree);
  options.friction = 0.4;
  const GraspPlan plan = plan_balls({ball}, options);
  REQUIRE_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps) {
    CHECK(grasp.friction_needed <= 0.4);
    CHECK(grasp.preshape <= franka_hand().max_opening + 1e-12);
    CHECK(grasp.preshape > grasp.width);
    for (int i = 0; i < 2; ++i) {
      CHECK((grasp.contacts_C[i] - ball.p_C).norm() == Approx(ball.radius));
      const Eigen::Vector3d p_G = grasp.X_CG.inverse() * grasp.contacts_C[i];
      CHECK(p_G.y() == Approx((i == 0 ? 0.5 : -0.5) * grasp.width));
      CHECK(std::abs(p_G.x()) < 0.5 * franka_hand().pad.x());
    }
  }
}

TEST_CASE("what is too wide, or too thin, is refused by width", "[plan][target]") {
  Gripper small = franka_hand();
  small.max_opening = 0.05;
  const GraspPlan wide =
      plan_balls({ball_on_table(0.0, 0.0, 0.03)}, with(UnknownPolicy::kFree), small);
  CHECK(wide.grasps.empty());
  CHECK(wide.rejected.at("width") > 10);
  Gripper thick = franka_hand();
  thick.min_opening = 0.065;
  const GraspPlan thin =
      plan_balls({ball_on_table(0.0, 0.0, 0.03)}, with(UnknownPolicy::kFree), thick);
  CHECK(thin.grasps.empty());
  CHECK(thin.rejected.at("width") > 10);
}

TEST_CASE("a ball nearly as wide as the hand opens is held beside its widest part",
          "[plan][target]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.039);
  const GraspPlan plan = plan_balls({ball}, with(UnknownPolicy::kFree));
  REQUIRE_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps) {
    CHECK(grasp.width < 2.0 * ball.radius);
    CHECK(grasp.preshape >= grasp.width + 2.0 * PlanOptions{}.pad_margin - 1e-12);
    for (const Eigen::Vector3d& contact_C : grasp.contacts_C) {
      CHECK((contact_C - ball.p_C).norm() == Approx(ball.radius));
    }
  }
}

TEST_CASE("a wall around the target is in the way of every hand", "[plan][target]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.02);
  std::vector<Ball> all = {ball};
  for (int k = 0; k < 10; ++k) {
    const double t = 2.0 * std::numbers::pi * k / 10;
    all.push_back(ball_on_table(0.062 * std::cos(t), 0.062 * std::sin(t), 0.035));
  }
  const GraspPlan plan = plan_balls(all, with(UnknownPolicy::kFree));
  CHECK(std::none_of(plan.grasps.begin(), plan.grasps.end(),
                     [](const Grasp& grasp) { return grasp.target == 1; }));
  CHECK(plan.rejected.at("collision") > 100);
}

TEST_CASE("unseen space is counted apart from what collides", "[plan][target]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  PlanOptions options = with(UnknownPolicy::kObstacle);
  options.clear_above = false;
  const GraspPlan careful = plan_balls({ball}, options);
  const GraspPlan bold = plan_balls({ball}, with(UnknownPolicy::kFree));
  CHECK(careful.rejected.at("unknown") > 10);
  CHECK(bold.rejected.count("unknown") == 0);
  CHECK(bold.grasps.size() >= careful.grasps.size());
}

TEST_CASE("a hand may come from beside the image, over space that was seen to be free", "[plan]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  PlanOptions options = with(UnknownPolicy::kObstacle);
  const auto refused = [&](bool clear_above) {
    options.clear_above = clear_above;
    const GraspPlan plan = plan_balls({ball}, options);
    CHECK(plan.grasps.size() > 3);
    return plan.rejected.count("unknown") > 0 ? plan.rejected.at("unknown") : 0;
  };
  CHECK(refused(true) < refused(false));
}

TEST_CASE("a further view frees what the first one did not see", "[plan]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  const std::vector<Detection> detections = {table_detection(), sphere_detection(ball)};
  const Eigen::Isometry3d turn = Eigen::Translation3d(ball.p_C) *
                                 Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) *
                                 Eigen::Translation3d(-ball.p_C);
  // The same ball from another place, where the table is another one.
  PointCloud other = render({{turn.inverse() * ball.p_C, ball.radius}});
  for (Eigen::Vector3f& p : other.points) p = turn.cast<float>() * p;
  other.viewpoint = turn.translation();
  const GraspPlan one = plan_grasps(render({ball}), detections, franka_hand());
  const GraspPlan two = plan_grasps(render({ball}), detections, franka_hand(), {}, {{other}});
  const auto count = [](const GraspPlan& plan, Voxel state) {
    return std::count(plan.space->states().begin(), plan.space->states().end(), state);
  };
  CHECK(count(two, Voxel::kUnknown) < count(one, Voxel::kUnknown));
  CHECK(count(two, Voxel::kOccupied) > count(one, Voxel::kOccupied));
}

TEST_CASE("points on a target that its surface does not explain are obstacles", "[plan][target]") {
  const Ball ball = ball_on_table(0.02, 0.01, 0.03);
  // Beads around the ball, which reach 6 mm beyond it: fingers that hold its sides would hit them.
  std::vector<Ball> beads;
  for (int k = 0; k < 54; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 54;
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    beads.push_back({ball.p_C + 0.034 * (table_detection().X_CQ.linear() * out), 0.002});
  }
  std::vector<Ball> all = beads;
  all.push_back(ball);
  const PointCloud plain = render({ball}), beaded = render(all);
  std::vector<Eigen::Vector3d> seen;
  for (const Eigen::Vector3f& p : beaded.points) {
    const double distance = (p.cast<double>() - ball.p_C).norm();
    if (distance > 0.033 && distance < 0.0361) seen.push_back(p.cast<double>());
  }
  REQUIRE(seen.size() > 30);
  const auto hits_beads = [&](const Grasp& grasp) {
    const Gripper hand = franka_hand();
    return std::any_of(seen.begin(), seen.end(), [&](const Eigen::Vector3d& p_C) {
      const Eigen::Vector3d p_G = grasp.X_CG.inverse() * p_C;
      return std::abs(p_G.x()) < 0.5 * hand.finger.x() && std::abs(p_G.z()) < 0.5 * hand.pad.y() &&
             std::abs(p_G.y()) > 0.5 * grasp.width && std::abs(p_G.y()) < 0.5 * grasp.preshape;
    });
  };
  PlanOptions options = with(UnknownPolicy::kFree);
  options.min_score = 0.0;
  const auto hits = [&](const PointCloud& points) {
    const GraspPlan plan = plan_grasps(points, detections_of({ball}), franka_hand(), options);
    return std::count_if(plan.grasps.begin(), plan.grasps.end(), hits_beads);
  };
  CHECK(hits(plain) > 3);
  CHECK(hits(beaded) == 0);
}
