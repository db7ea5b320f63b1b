// How many grasps of each target a plan has, and how they differ.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "grasping/plans.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "targets/spread.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

const std::vector<Ball>& three_balls() {
  static const std::vector<Ball> balls = {ball_on_table(-0.15, 0.0, 0.03),
                                          ball_on_table(0.0, 0.0, 0.025),
                                          ball_on_table(0.15, 0.0, 0.02)};
  return balls;
}

/// The planner of three balls, to whom nothing unseen is in the way.
const GraspScene& with_balls() {
  static const GraspScene scene(render(three_balls()), detections_of(three_balls()), franka_hand(),
                                with(UnknownPolicy::kFree));
  return scene;
}

GraspPlan plan_each(int per_target, int max_grasps = 10000) {
  GraspQuery query;
  query.per_target = per_target;
  query.max_grasps = max_grasps;
  return with_balls().plan(query);
}

std::map<int, std::vector<Grasp>> by_target(const GraspPlan& plan) {
  std::map<int, std::vector<Grasp>> grasps;
  for (const Grasp& grasp : plan.grasps) grasps[grasp.target].push_back(grasp);
  return grasps;
}

/// Whether a grasp adds nothing to another one: nearer than 12 mm and turned by less than 20°.
bool alike(const Grasp& a, const Grasp& b) {
  const double cosine = std::cos(20.0 * std::numbers::pi / 180.0);
  const auto middle = [](const Grasp& g) -> Eigen::Vector3d {
    return 0.5 * (g.contacts_C[0] + g.contacts_C[1]);
  };
  return (middle(a) - middle(b)).norm() < 0.012 &&
         a.X_CG.linear().col(2).dot(b.X_CG.linear().col(2)) > cosine &&
         std::abs(a.X_CG.linear().col(1).dot(b.X_CG.linear().col(1))) > cosine;
}

double least_difference(const std::vector<Grasp>& grasps, double reach) {
  double least = 1.0;
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, difference(grasps[i], grasps[j], reach));
    }
  }
  return least;
}

}  // namespace

TEST_CASE("each target has as many grasps as are asked for, the best of all first",
          "[plan][per_target]") {
  const auto usual = by_target(with_balls().plan());
  REQUIRE(usual.size() == 3);
  for (const int count : {1, 3, 7, 30}) {
    const auto asked = by_target(plan_each(count));
    CAPTURE(count);
    REQUIRE(asked.size() == 3);
    for (const auto& [target, grasps] : asked) {
      CHECK(grasps.size() == static_cast<std::size_t>(count));
      CHECK(grasps.front().score >= usual.at(target).front().score);
    }
  }
}

TEST_CASE("a search that goes on finds no two grasps that are alike", "[plan][per_target]") {
  const auto all = by_target(plan_each(10000));
  for (const auto& [target, grasps] : all) {
    CAPTURE(target);
    // It ends with the candidates, far beyond the dozen of an ordinary search.
    CHECK(grasps.size() > 30);
    CHECK(grasps.size() < 5000);
    for (std::size_t i = 0; i < grasps.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(alike(grasps[i], grasps[j]));
    }
  }
}

TEST_CASE("a few grasps of a target differ more than its best ones do", "[plan][per_target]") {
  const auto usual = by_target(with_balls().plan()), few = by_target(plan_each(3));
  for (const auto& [target, grasps] : few) {
    CAPTURE(target);
    std::vector<Grasp> best = usual.at(target);
    REQUIRE(best.size() > 3);
    best.resize(3);
    const double reach = three_balls()[target - 1].radius;
    CHECK(least_difference(grasps, reach) > least_difference(best, reach));
    // They are among those that are found without the request.
    for (const Grasp& grasp : grasps) {
      CHECK(std::any_of(usual.at(target).begin(), usual.at(target).end(), [&](const Grasp& other) {
        return other.X_CG.matrix() == grasp.X_CG.matrix() && other.score == grasp.score;
      }));
    }
  }
}

TEST_CASE("the number of a query wins over that of the options", "[plan][per_target]") {
  PlanOptions options = with(UnknownPolicy::kFree);
  options.per_target = 2;
  const GraspScene scene(render(three_balls()), detections_of(three_balls()), franka_hand(),
                         options);
  CHECK(scene.plan().grasps.size() == 6);
  GraspQuery query;
  query.per_target = 4;
  CHECK(scene.plan(query).grasps.size() == 12);
  query.per_target = 0;
  check_same_grasps(scene.plan(query), with_balls().plan());
}

TEST_CASE("if all are too many, each target keeps as many as the others, and a warning says so",
          "[plan][per_target]") {
  const GraspPlan plan = plan_each(5, 7);
  std::vector<std::size_t> counts;
  for (const auto& [target, grasps] : by_target(plan)) counts.push_back(grasps.size());
  std::sort(counts.begin(), counts.end());
  CHECK(counts == std::vector<std::size_t>{2, 2, 3});
  REQUIRE(plan.warnings.size() == 1);
  CHECK(plan.warnings[0] == "of 15 grasps only 7 are given; raise planner.max_grasps (--best)");
  CHECK(plan_each(2, 6).warnings.empty());
  CHECK(std::is_sorted(plan.grasps.begin(), plan.grasps.end(),
                       [](const Grasp& one, const Grasp& next) { return one.score > next.score; }));
}

TEST_CASE("other kinds of holds are tried if one kind gives too few", "[plan][per_target]") {
  const std::vector<Ball> ball = {ball_on_table(0.0, 0.0, 0.03)};
  PlanOptions options = with(UnknownPolicy::kFree);
  options.min_score = 0.0;
  const GraspScene scene(render(ball), detections_of(ball), franka_hand(), options);
  GraspQuery query;
  const std::size_t usual = scene.plan(query).grasps.size();
  query.per_target = 1000;
  query.max_grasps = 1000;
  const GraspPlan plan = scene.plan(query);
  CHECK(plan.grasps.size() > usual);
  std::set<GraspKind> kinds;
  for (const Grasp& grasp : plan.grasps) kinds.insert(grasp.kind);
  CHECK(kinds.size() > 1);
  for (std::size_t i = 0; i < plan.grasps.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(alike(plan.grasps[i], plan.grasps[j]));
  }
}
