#include "targets/spread.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"

namespace quadrille {
namespace {

constexpr double kPi = std::numbers::pi;

Grasp grasp_at(double x, double score, double angle = 0.0,
               const Eigen::Vector3d& axis = Eigen::Vector3d::UnitZ()) {
  Grasp grasp;
  grasp.X_CG = Eigen::Translation3d(x, 0.0, 0.0) * Eigen::AngleAxisd(angle, axis);
  grasp.score = score;
  return grasp;
}

std::vector<double> scores_of(const std::vector<Grasp>& grasps) {
  std::vector<double> scores;
  for (const Grasp& grasp : grasps) scores.push_back(grasp.score);
  return scores;
}

}  // namespace

TEST_CASE("grasps differ by place, approach and closing line, up to 1", "[spread]") {
  const Eigen::Vector3d x(1, 0, 0), z(0, 0, 1);
  const Grasp here = grasp_at(0.0, 1.0);
  const auto to = [&](const Grasp& other) {
    CHECK(difference(here, other, 0.05) == difference(other, here, 0.05));
    return difference(here, other, 0.05);
  };
  CHECK(to(here) == 0.0);
  CHECK(to(grasp_at(0.02, 1.0)) == Approx(0.4));
  CHECK(to(grasp_at(0.5, 1.0)) == 1.0);
  // About x both the approach and the closing line turn, about z the closing line alone, about y
  // the approach alone.
  CHECK(to(grasp_at(0.0, 1.0, kPi / 6, x)) == Approx(1.0 / 3.0));
  CHECK(to(grasp_at(0.0, 1.0, kPi / 6, z)) == Approx(1.0 / 3.0));
  CHECK(to(grasp_at(0.0, 1.0, kPi, Eigen::Vector3d::UnitY())) == 1.0);
  // The pads change places.
  CHECK(to(grasp_at(0.0, 1.0, kPi, z)) == Approx(0.0).margin(1e-12));
  CHECK(to(grasp_at(0.0, 1.0, 5 * kPi / 6, z)) == Approx(1.0 / 3.0));
  // The larger one counts.
  CHECK(to(grasp_at(0.02, 1.0, kPi / 6, z)) == Approx(0.4));
}

TEST_CASE("the best grasp is picked first, and then what adds most to those picked", "[spread]") {
  // In a row, 1 being half the target's size.
  const std::vector<Grasp> row = {grasp_at(0.1, 0.8), grasp_at(0.0, 0.9), grasp_at(0.5, 0.7),
                                  grasp_at(1.0, 0.5)};
  // After .9 at 0: .8 · .1, .7 · .5 and .5 · 1. After that: .8 · .1 and .7 · .5.
  CHECK(scores_of(spread(row, 4, 1.0)) == std::vector{0.9, 0.5, 0.7, 0.8});
  CHECK(scores_of(spread(row, 2, 1.0)) == std::vector{0.9, 0.5});
  // On a large target the same places are near each other, and scores decide.
  CHECK(scores_of(spread({row[0], row[1], grasp_at(0.11, 0.1)}, 3, 10.0)) ==
        std::vector{0.9, 0.8, 0.1});
  CHECK(spread(row, 9, 1.0).size() == 4);
  CHECK(spread(row, 0, 1.0).empty());
  CHECK(spread({}, 3, 1.0).empty());
}

TEST_CASE("of equals the first is picked, and doubles come last", "[spread]") {
  std::vector<Grasp> grasps(3, grasp_at(0.0, 0.6));
  for (int n = 0; n < 3; ++n) grasps[n].target = n;
  grasps.push_back(grasp_at(0.3, 0.1));
  const std::vector<Grasp> picks = spread(grasps, 4, 1.0);
  REQUIRE(picks.size() == 4);
  CHECK(picks[0].target == 0);
  CHECK(picks[1].score == 0.1);
  CHECK(picks[2].target == 1);
  CHECK(picks[3].target == 2);
  // Grasps that cannot succeed are picked too.
  CHECK(spread({grasp_at(0.0, 0.0), grasp_at(1.0, 0.0)}, 2, 1.0).size() == 2);
}

}  // namespace quadrille
