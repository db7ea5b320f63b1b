#include "quadrille/grasping/plan.hpp"

#include <octomap/OcTree.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

#include "grasping/plans.hpp"
#include "hand/hand.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// True if a finger or the palm, on its way in, holds a point of a ball.
bool touches(const Grasp& g, const std::vector<Ball>& balls) {
  const SweptHand hand = sweep_hand(franka_hand(), g.X_CG, g.preshape, g.width, g.approach);
  for (const OrientedBox& box : {hand.fingers[0], hand.fingers[1], hand.palm}) {
    for (const Ball& ball : balls) {
      for (const Eigen::Vector3d& p : skin(ball)) {
        if (box.contains(p)) return true;
      }
    }
  }
  return false;
}

}  // namespace

TEST_CASE("a ball on a table is grasped across its diameter", "[plan]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  const GraspPlan plan = plan_balls({ball});
  REQUIRE_FALSE(plan.grasps.empty());
  const Grasp& best = plan.grasps.front();
  CHECK(best.target == 1);
  CHECK(best.width == Approx(0.06));
  CHECK(best.friction_needed == Approx(0.0).margin(1e-6));
  CHECK(best.preshape > best.width);
  CHECK(best.preshape <= 0.08 + 1e-12);
  CHECK(best.score > 0.0);
  CHECK(best.score <= 1.0);
  CHECK(best.epsilon > 0.0);
  CHECK(((best.contacts_C[0] + best.contacts_C[1]) / 2 - ball.p_C).norm() < 1e-9);
  CHECK(best.X_CG.linear().determinant() == Approx(1.0));
  CHECK(!plan.space->states().empty());
  CHECK(plan.shapes.size() == 2);
}

TEST_CASE("no planned hand touches any true surface, seen or hidden", "[plan][collision]") {
  const std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03), ball_on_table(0.1, 0.05, 0.025),
                                   ball_on_table(-0.12, 0.02, 0.035),
                                   ball_on_table(0.03, 0.13, 0.02)};
  const Detection table = table_detection();
  for (const UnknownPolicy policy : {UnknownPolicy::kWeighed, UnknownPolicy::kObstacle,
                                     UnknownPolicy::kTargetShadow, UnknownPolicy::kFree}) {
    const GraspPlan plan = plan_balls(balls, with(policy));
    REQUIRE(plan.grasps.size() >= 4);
    for (const Grasp& g : plan.grasps) {
      CHECK_FALSE(touches(g, balls));
      const SweptHand hand = sweep_hand(franka_hand(), g.X_CG, g.preshape, g.width, g.approach);
      const Eigen::Vector3d n = table.X_CQ.linear().col(2);
      for (const OrientedBox& box : {hand.fingers[0], hand.fingers[1], hand.palm}) {
        CHECK(-box.support(-n) > n.dot(table.X_CQ.translation()));
      }
    }
  }
}

TEST_CASE("a more permissive policy reaches all that a stricter one does", "[plan][policy]") {
  const std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03), ball_on_table(0.0, 0.09, 0.03),
                                   ball_on_table(0.0, -0.09, 0.03)};
  const auto obstacle = targets_of(plan_balls(balls, with(UnknownPolicy::kObstacle)));
  const auto shadow = targets_of(plan_balls(balls, with(UnknownPolicy::kTargetShadow)));
  const auto free = targets_of(plan_balls(balls, with(UnknownPolicy::kFree)));
  CHECK(std::includes(shadow.begin(), shadow.end(), obstacle.begin(), obstacle.end()));
  CHECK(std::includes(free.begin(), free.end(), shadow.begin(), shadow.end()));
  CHECK(free.size() == 3);
}

TEST_CASE("a weighed grasp through unknown space counts less than if that space were free",
          "[plan][policy]") {
  const std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03)};
  PlanOptions weighed = with(UnknownPolicy::kWeighed), free = with(UnknownPolicy::kFree);
  weighed.min_score = free.min_score = 0.0;
  const GraspPlan careful = plan_balls(balls, weighed), bold = plan_balls(balls, free);
  // The hands that pass are the same; their scores are not.
  REQUIRE(careful.grasps.size() == bold.grasps.size());
  bool lowered = false;
  for (const Grasp& grasp : careful.grasps) {
    const auto same = std::find_if(bold.grasps.begin(), bold.grasps.end(), [&](const Grasp& other) {
      return other.X_CG.matrix() == grasp.X_CG.matrix();
    });
    REQUIRE(same != bold.grasps.end());
    CHECK(same->terms.seen == 1.0);
    CHECK((grasp.score < same->score) == (grasp.terms.seen < 1.0));
    lowered |= grasp.terms.seen < 1.0;
  }
  CHECK(lowered);
}

TEST_CASE("the plan is the same each time, best first", "[plan][determinism]") {
  const std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03), ball_on_table(0.1, 0.0, 0.025)};
  const GraspPlan a = plan_balls(balls), b = plan_balls(balls);
  check_same_grasps(a, b);
  CHECK(a.rejected == b.rejected);
  CHECK(std::is_sorted(a.grasps.begin(), a.grasps.end(),
                       [](const Grasp& one, const Grasp& next) { return one.score > next.score; }));
}

TEST_CASE("grasps move with the scene", "[plan][law]") {
  std::mt19937 random(12);
  PointCloud cloud;
  for (int i = 0; i < 50; ++i) cloud.points.emplace_back(3.0f, 0.01f * i, 3.0f);
  for (const Detection& d : solid_detections()) {
    const Eigen::Isometry3d X = random_pose(random);
    Detection here = d, there = d;
    here.X_CQ.translation() = Eigen::Vector3d(0.05, 0.02, 0.7);
    there.X_CQ = X * here.X_CQ;
    PointCloud moved = cloud;
    moved.viewpoint = X.translation();
    for (Eigen::Vector3f& p : moved.points) p = (X * p.cast<double>()).cast<float>();
    const PlanOptions options = with(UnknownPolicy::kFree);
    const GraspPlan a = plan_grasps(cloud, {here}, franka_hand(), options);
    const GraspPlan b = plan_grasps(moved, {there}, franka_hand(), options);
    CAPTURE(to_string(d.type));
    CHECK(a.grasps.empty() == b.grasps.empty());
    if (a.grasps.empty()) continue;
    CHECK(a.grasps.size() == b.grasps.size());
    // The best grasp may be another one, since directions are tried from another first one on.
    CHECK(a.grasps.front().score == Approx(b.grasps.front().score).epsilon(0.05));
  }
}

TEST_CASE("every solid of the hand's size is grasped where nothing is in the way", "[plan]") {
  for (Detection d : solid_detections()) {
    d.X_CQ.translation() = Eigen::Vector3d(0.0, 0.0, 0.7);
    const GraspPlan plan = plan_alone({d});
    CAPTURE(to_string(d.type), plan.rejected);
    CHECK_FALSE(plan.grasps.empty());
    for (const Grasp& grasp : plan.grasps) CHECK(grasp.friction_needed <= 0.5);
  }
}

TEST_CASE("a neighbour without a gap keeps the fingers out", "[plan][collision]") {
  // Two balls that touch: no grasp may close across their common point.
  const std::vector<Ball> balls = {ball_on_table(-0.03, 0.0, 0.03), ball_on_table(0.03, 0.0, 0.03)};
  const GraspPlan plan = plan_balls(balls, with(UnknownPolicy::kFree));
  for (const Grasp& grasp : plan.grasps) {
    CHECK_FALSE(touches(grasp, balls));
    CHECK(std::abs(grasp.X_CG.linear()(0, 1)) < 0.9);
  }
  CHECK(plan.rejected.at("collision") > 0);
}

TEST_CASE("a cap does not block the grasp of its own cylinder", "[plan]") {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation().z() = 0.7;
  const Detection can = cylinder_detection(X, 0.03, 0.06);
  Detection cap = table_detection(2);
  cap.X_CQ = X;
  cap.X_CQ.translation().z() = 0.67;
  cap.X_CQ.linear() = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).matrix();
  cap.extent_Q = {Eigen::Vector3d(-0.03, -0.03, 0), Eigen::Vector3d(0.03, 0.03, 0)};
  const GraspPlan alone = plan_alone({can}), both = plan_alone({can, cap});
  CHECK_FALSE(alone.grasps.empty());
  CHECK(both.grasps.size() == alone.grasps.size());
}

TEST_CASE("without a cloud all space is unknown and the answer says so", "[plan][hostile]") {
  const Detection ball = sphere_detection(ball_on_table(0.0, 0.0, 0.03));
  for (const auto& [policy, why] : {std::pair(UnknownPolicy::kWeighed, "score"),
                                    std::pair(UnknownPolicy::kObstacle, "unknown")}) {
    const GraspPlan plan = plan_grasps({}, {ball}, franka_hand(), with(policy));
    CHECK(plan.grasps.empty());
    CHECK(plan.rejected.at(why) > 0);
    CHECK_FALSE(plan.warnings.empty());
  }
  const GraspPlan free = plan_grasps({}, {ball}, franka_hand(), with(UnknownPolicy::kFree));
  CHECK_FALSE(free.grasps.empty());
  CHECK(free.grasps.front().unknown_contact);
}

TEST_CASE("without detections there is nothing to grasp and no failure", "[plan][hostile]") {
  const GraspPlan plan = plan_grasps(render(std::vector<Ball>{}), {}, franka_hand());
  CHECK(plan.grasps.empty());
  CHECK(plan.shapes.empty());
  REQUIRE(plan.space);
  CHECK(plan.total_ms > 0.0);
}

TEST_CASE("a viewpoint inside the object, at infinity or on a point never crashes the planner",
          "[plan][hostile]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  PointCloud cloud = render({ball});
  for (const Eigen::Vector3d& viewpoint :
       {ball.p_C, Eigen::Vector3d(Eigen::Vector3d::Constant(std::nan(""))),
        Eigen::Vector3d(Eigen::Vector3d::Constant(1e30)),
        Eigen::Vector3d(cloud.points[kWidth * kHeight / 2].cast<double>())}) {
    cloud.viewpoint = viewpoint;
    const GraspPlan plan =
        plan_grasps(cloud, {sphere_detection(ball), table_detection()}, franka_hand());
    for (const Grasp& grasp : plan.grasps) CHECK(grasp.X_CG.matrix().allFinite());
    CHECK(plan.rejected.size() + plan.grasps.size() > 0);
  }
}

TEST_CASE("a detection where free space was seen is contradicted", "[plan]") {
  const PointCloud cloud = render(std::vector<Ball>{});
  const Detection ghost = sphere_detection(ball_on_table(0.0, 0.0, 0.03));
  Detection high = ghost;
  high.X_CQ.translation() += 0.08 * table_detection().X_CQ.linear().col(2);
  const GraspPlan plan = plan_grasps(cloud, {high}, franka_hand(), with(UnknownPolicy::kFree));
  CHECK(plan.grasps.empty());
  CHECK(plan.rejected.at("contradicted") > 0);
}

TEST_CASE("options out of range are refused by name", "[plan]") {
  const std::pair<const char*, void (*)(PlanOptions&)> spoiled[] = {
      {"resolution", [](PlanOptions& o) { o.resolution = 0.0; }},
      {"friction", [](PlanOptions& o) { o.friction = std::nan(""); }},
      {"approach", [](PlanOptions& o) { o.approach = -1.0; }},
      {"pad_margin", [](PlanOptions& o) { o.pad_margin = 1.0; }},
      {"baseline", [](PlanOptions& o) { o.baseline = -0.1; }},
      {"min_wall", [](PlanOptions& o) { o.min_wall = 0.02; }},
      {"max_wall", [](PlanOptions& o) { o.max_wall = 1.0; }},
      {"min_score", [](PlanOptions& o) { o.min_score = 1.1; }},
      {"per_target", [](PlanOptions& o) { o.per_target = -1; }},
      {"max_grasps", [](PlanOptions& o) { o.max_grasps = 0; }},
      {"max_detections", [](PlanOptions& o) { o.max_detections = 0; }},
      {"deadline_ms", [](PlanOptions& o) { o.deadline_ms = -1.0; }},
      {"threads", [](PlanOptions& o) { o.threads = 0; }},
      {"reach.base",
       [](PlanOptions& o) {
         o.reach.base = {0.0, std::nan(""), 0.0};
       }},
      {"reach.base has 2 numbers",
       [](PlanOptions& o) {
         o.reach.base = {0.0, 0.0};
       }},
      {"reach.min", [](PlanOptions& o) { o.reach.min = -1.0; }},
      {"reach.min",
       [](PlanOptions& o) {
         o.reach = {{0.0, 0.0, 0.0}, 2.0, 1.0};
       }},
      {"reach.max", [](PlanOptions& o) { o.reach.max = std::nan(""); }}};
  for (const auto& [field, spoil] : spoiled) {
    PlanOptions options;
    spoil(options);
    CHECK_THROWS_WITH(plan_grasps({}, {}, franka_hand(), options),
                      Catch::Matchers::StartsWith(std::string("planner.") + field));
  }
}

TEST_CASE("a visit reaches each option of the planner", "[plan]") {
  // A new field stops these lines from compiling until it is listed here, and visited.
  PlanOptions options;
  auto& [unknown, types, resolution, friction, approach, pad_margin, baseline, min_wall, max_wall,
         clear_above, min_score, per_target, max_grasps, max_detections, deadline_ms, threads,
         reach] = options;
  auto& [base, min, max] = reach;
  const std::set<const void*> fields = {
      &unknown,     &types,    &resolution,  &friction,  &approach,   &pad_margin, &baseline,
      &min_wall,    &max_wall, &clear_above, &min_score, &per_target, &max_grasps, &max_detections,
      &deadline_ms, &threads,  &base,        &min,       &max};
  std::set<const void*> visited;
  PlanOptions::visit(options, [&](auto& field, const Setting&) { visited.insert(&field); });
  CHECK(visited == fields);
}

TEST_CASE("each target keeps its best grasp when only few are asked for", "[plan]") {
  const std::vector<Ball> balls = {ball_on_table(-0.1, 0.0, 0.03), ball_on_table(0.1, 0.0, 0.025)};
  PlanOptions options = with(UnknownPolicy::kFree);
  options.max_grasps = 2;
  const GraspPlan plan = plan_balls(balls, options);
  CHECK(plan.grasps.size() == 2);
  CHECK(targets_of(plan).size() == 2);
}

TEST_CASE("a detection without a shape is counted, and a warning says why", "[plan]") {
  Detection flat = table_detection(7);
  flat.extent_Q = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  flat.dimensions.clear();
  const GraspPlan plan = plan_grasps(render(std::vector<Ball>{}), {flat}, franka_hand());
  CHECK(plan.rejected.at("no_shape") == 1);
  REQUIRE(plan.warnings.size() == 1);
  CHECK(plan.warnings[0] == "quadric 7 has no collision shape: plane has no finite, positive size");
}
