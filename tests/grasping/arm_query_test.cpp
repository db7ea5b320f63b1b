// Queries that say how far an arm reaches, or bring a function that accepts or refuses each grasp.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "grasping/plans.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/grasp_scene.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

const std::vector<Ball>& two_balls() {
  static const std::vector<Ball> balls = {ball_on_table(-0.15, 0.0, 0.03),
                                          ball_on_table(0.15, 0.0, 0.025)};
  return balls;
}

const GraspScene& with_arm() {
  static const GraspScene scene(render(two_balls()), detections_of(two_balls()), franka_hand(),
                                with(UnknownPolicy::kFree));
  return scene;
}

/// The base on the table, half a metre to the side of the first ball.
Eigen::Vector3d base_C() { return two_balls()[0].p_C + Eigen::Vector3d(-0.5, 0.0, 0.0); }

GraspQuery within(double min, double max) {
  GraspQuery query;
  query.reach = Reach{base_C(), min, max};
  return query;
}

void check_within(const GraspPlan& plan, const Reach& reach) {
  for (const Grasp& grasp : plan.grasps) {
    for (const Eigen::Vector3d& p_C : {Eigen::Vector3d(grasp.X_CG.translation()),
                                       Eigen::Vector3d(grasp.pregrasp().translation())}) {
      const double distance = (p_C - reach.base_C).norm();
      CHECK(distance >= reach.min - 1e-9);
      CHECK(distance <= reach.max + 1e-9);
    }
  }
}

}  // namespace

TEST_CASE("the hand stays within reach at the grasp and before it", "[query][reach]") {
  const GraspPlan all = with_arm().plan();
  REQUIRE(targets_of(all) == std::set{1, 2});
  // Reaches that end at the ball itself, so that only some ways lead there.
  for (const GraspQuery& query : {within(0.0, 0.5), within(0.5, 5.0), within(0.48, 0.53)}) {
    const GraspPlan plan = with_arm().plan(query);
    CAPTURE(query.reach->min, query.reach->max);
    check_within(plan, *query.reach);
    CHECK(targets_of(plan).contains(1));
    CHECK(plan.rejected.at("reach") > 0);
    // The search is guided: it finds at least as many as were within reach by chance.
    const auto by_chance = std::count_if(all.grasps.begin(), all.grasps.end(), [&](const Grasp& g) {
      return g.target == 1 && query.reach->contains(g.X_CG.translation()) &&
             query.reach->contains(g.pregrasp().translation());
    });
    CHECK(std::count_if(plan.grasps.begin(), plan.grasps.end(),
                        [](const Grasp& g) { return g.target == 1; }) >= by_chance);
  }
}

TEST_CASE("a reach that holds everything changes nothing", "[query][reach]") {
  const GraspPlan plan = with_arm().plan(within(0.0, 100.0));
  check_same_grasps(plan, with_arm().plan());
  CHECK_FALSE(plan.rejected.contains("reach"));
}

TEST_CASE("a target out of reach is refused before any hand is tried on it", "[query][reach]") {
  // The second ball is 0.8 m away.
  const GraspPlan near = with_arm().plan(within(0.0, 0.6));
  CHECK(targets_of(near) == std::set{1});
  // Even with the length of a hand between them the arm is too short.
  GraspQuery query = within(0.0, 0.45);
  query.ids = {2};
  const GraspPlan none = with_arm().plan(query);
  CHECK(none.grasps.empty());
  CHECK(none.rejected == std::map<std::string, int>{{"reach", 1}});
  query.reach->min = query.reach->max = 3.0;
  CHECK(with_arm().plan(query).rejected == std::map<std::string, int>{{"reach", 1}});
}

TEST_CASE("the reach of a query wins over that of the options", "[query][reach]") {
  PlanOptions options = with(UnknownPolicy::kFree);
  const Eigen::Vector3d base = base_C();
  options.reach = {{base.x(), base.y(), base.z()}, 0.0, 0.6};
  const GraspScene scene(render(two_balls()), detections_of(two_balls()), franka_hand(), options);
  check_same_grasps(scene.plan(), with_arm().plan(within(0.0, 0.6)));
  check_same_grasps(scene.plan(within(0.0, 100.0)), with_arm().plan());
}

TEST_CASE("holds by the tips and by the points keep within reach as well", "[query][reach]") {
  GraspQuery query = within(0.49, 0.56);
  query.ids = {1};
  query.per_target = 1000;
  query.max_grasps = 1000;
  query.min_score = 0.0;
  const GraspPlan plan = with_arm().plan(query);
  CHECK(std::any_of(plan.grasps.begin(), plan.grasps.end(),
                    [](const Grasp& grasp) { return grasp.terms.shape == 0.0; }));
  CHECK(std::any_of(plan.grasps.begin(), plan.grasps.end(),
                    [](const Grasp& grasp) { return grasp.kind == GraspKind::kTip; }));
  check_within(plan, *query.reach);
}

TEST_CASE("a caller who accepts all changes nothing, and is asked about each grasp once",
          "[query][accept]") {
  const GraspPlan plain = with_arm().plan();
  std::vector<Grasp> asked;
  GraspQuery query;
  query.accept = [&](const Grasp& grasp) {
    asked.push_back(grasp);
    return true;
  };
  check_same_grasps(with_arm().plan(query), plain);
  CHECK(asked.size() == plain.grasps.size());
  for (const Grasp& grasp : plain.grasps) {
    CHECK(std::count_if(asked.begin(), asked.end(), [&](const Grasp& other) {
            return other.X_CG.matrix() == grasp.X_CG.matrix() && other.score == grasp.score &&
                   other.clearance == grasp.clearance && other.target == grasp.target;
          }) == 1);
  }
  // The order is the same each time.
  const std::vector<Grasp> first = std::exchange(asked, {});
  with_arm().plan(query);
  REQUIRE(asked.size() == first.size());
  for (std::size_t n = 0; n < first.size(); ++n) {
    CHECK(asked[n].X_CG.matrix() == first[n].X_CG.matrix());
  }
}

TEST_CASE("what a caller refuses is counted, and the search goes on", "[query][accept]") {
  GraspQuery query;
  int calls = 0;
  query.accept = [&](const Grasp&) {
    ++calls;
    return false;
  };
  const GraspPlan none = with_arm().plan(query);
  CHECK(none.grasps.empty());
  CHECK(calls > 24);
  CHECK(none.rejected.at("caller") == calls);
  // From the left only: there are more of these than among the dozen that are found without.
  const auto from_left = [](const Grasp& grasp) { return grasp.X_CG.linear()(0, 2) > 0.2; };
  query.accept = from_left;
  const GraspPlan left = with_arm().plan(query), plain = with_arm().plan();
  CHECK(std::all_of(left.grasps.begin(), left.grasps.end(), from_left));
  CHECK(static_cast<long>(left.grasps.size()) >
        std::count_if(plain.grasps.begin(), plain.grasps.end(), from_left));
}

TEST_CASE("a caller is asked in the frame of the query, wherever the query is moved",
          "[query][accept]") {
  const Eigen::Isometry3d X_FC =
      Eigen::Translation3d(1.0, -2.0, 0.5) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY());
  std::vector<Eigen::Isometry3d> asked;
  GraspQuery in_F;
  in_F.reach = Reach{X_FC * base_C(), 0.0, 0.6};
  in_F.accept = [&](const Grasp& grasp) {
    asked.push_back(grasp.X_CG);
    return true;
  };
  const GraspQuery in_C = moved(in_F, X_FC.inverse());
  CHECK(in_C.reach->base_C.isApprox(base_C(), 1e-12));
  const GraspPlan plan = with_arm().plan(in_C);
  REQUIRE(asked.size() == plan.grasps.size());
  for (const Grasp& grasp : plan.grasps) {
    CHECK(std::any_of(asked.begin(), asked.end(), [&](const Eigen::Isometry3d& X_FG) {
      return X_FG.isApprox(X_FC * grasp.X_CG, 1e-12);
    }));
  }
}

TEST_CASE("an exception of the caller passes through the plan", "[query][accept]") {
  GraspQuery query;
  query.accept = [](const Grasp&) -> bool { throw std::domain_error("the arm is off"); };
  CHECK_THROWS_AS(with_arm().plan(query), std::domain_error);
  CHECK_FALSE(with_arm().plan().grasps.empty());
}

TEST_CASE("the least score of a query wins over that of the options", "[query][score]") {
  GraspQuery strict, lenient;
  const double best = with_arm().plan().grasps.front().score;
  strict.min_score = best;
  const GraspPlan few = with_arm().plan(strict);
  REQUIRE_FALSE(few.grasps.empty());
  for (const Grasp& grasp : few.grasps) CHECK(grasp.score >= best);
  CHECK(few.rejected.at("score") > 0);
  strict.min_score = 1.0;
  CHECK(with_arm().plan(strict).grasps.empty());
  lenient.min_score = 0.0;
  CHECK_FALSE(with_arm().plan(lenient).rejected.contains("score"));
}

TEST_CASE("a query takes from the options what it leaves open, and nothing else", "[query]") {
  PlanOptions options;
  options.reach = {{1.0, 2.0, 3.0}, 0.25, 0.75};
  options.min_score = 0.6;
  options.per_target = 4;
  options.max_grasps = 9;
  options.deadline_ms = 70.0;
  const GraspQuery open = completed({}, options);
  CHECK(open.reach->base_C == Eigen::Vector3d(1.0, 2.0, 3.0));
  CHECK(open.reach->min == 0.25);
  CHECK(open.reach->max == 0.75);
  CHECK(open.min_score == 0.6);
  CHECK(open.per_target == 4);
  CHECK(open.max_grasps == 9);
  CHECK(open.deadline_ms == 70.0);
  GraspQuery full = within(0.0, 1.0);
  full.min_score = 0.1;
  full.per_target = 1;
  full.max_grasps = 2;
  full.deadline_ms = 3.0;
  const GraspQuery same = completed(full, options);
  CHECK(same.reach->max == 1.0);
  CHECK(same.min_score == 0.1);
  CHECK(same.per_target == 1);
  CHECK(same.max_grasps == 2);
  CHECK(same.deadline_ms == 3.0);
  CHECK_FALSE(completed({}, PlanOptions()).reach);
  options.reach.base = {1.0};
  CHECK_THROWS_AS(completed({}, options), std::invalid_argument);
}
