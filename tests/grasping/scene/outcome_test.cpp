#include "scene/outcome.hpp"

#include <utility>
#include <vector>

#include "support/catch.hpp"

namespace quadrille {
namespace {

Grasp grasp_at(double x, double score) {
  Grasp grasp;
  grasp.X_CG = Eigen::Translation3d(x, 0.0, 0.0);
  grasp.contacts_C = {Eigen::Vector3d(x, 0.02, 0.0), Eigen::Vector3d(x, -0.02, 0.0)};
  grasp.score = score;
  return grasp;
}

}  // namespace

TEST_CASE("of like grasps on two parts of a body the best one stays", "[outcome]") {
  std::vector<Outcome> parts(2);
  parts[0].grasps = {grasp_at(0.0, 0.7), grasp_at(0.1, 0.9)};
  parts[0].refusals = {{Refusal::kWidth, 2}};
  parts[1].grasps = {grasp_at(0.004, 0.8), grasp_at(-0.1, 0.6)};
  parts[1].refusals = {{Refusal::kWidth, 3}, {Refusal::kTwist, 1}};
  parts[1].cut = true;
  const Outcome body = joined(std::move(parts));
  REQUIRE(body.grasps.size() == 3);
  CHECK(body.grasps[0].score == 0.9);
  CHECK(body.grasps[1].score == 0.8);
  CHECK(body.grasps[2].score == 0.6);
  CHECK(body.refusals == RefusalCounts{{Refusal::kWidth, 5}, {Refusal::kTwist, 1}});
  CHECK(body.cut);
}

TEST_CASE("candidates too unlikely to be tried count only if nothing tells more", "[outcome]") {
  Outcome found;
  found.unlikely = 7;
  found.refusals = {{Refusal::kWidth, 2}};
  CHECK(told_refusals(found) == RefusalCounts{{Refusal::kWidth, 2}, {Refusal::kScore, 7}});
  found.refusals[Refusal::kCollision] = 1;
  CHECK(told_refusals(found) == found.refusals);
  found.cut = true;
  CHECK(told_refusals(found).at(Refusal::kDeadline) == 1);
  found.refusals.erase(Refusal::kCollision);
  found.grasps = {grasp_at(0.0, 0.7)};
  CHECK(told_refusals(found) == RefusalCounts{{Refusal::kWidth, 2}, {Refusal::kDeadline, 1}});
}

}  // namespace quadrille
