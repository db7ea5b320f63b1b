#include "contacts/directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a fan turns in even steps from its first direction", "[directions]") {
  const auto fanned = fan(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), 12, std::numbers::pi);
  REQUIRE(fanned.size() == 12);
  CHECK(fanned[0].isApprox(Eigen::Vector3d::UnitY()));
  CHECK(fanned[6].isApprox(Eigen::Vector3d::UnitZ()));
  for (std::size_t n = 1; n < fanned.size(); ++n) {
    CHECK(fanned[n].norm() == Approx(1.0));
    CHECK(fanned[n].dot(fanned[n - 1]) == Approx(std::cos(std::numbers::pi / 12)));
  }
}

TEST_CASE("no direction lies far from one of the half sphere or its opposite", "[directions]") {
  std::mt19937 random(31);
  const auto directions = half_sphere(100);
  REQUIRE(directions.size() == 100);
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector3d any = random_rotation(random).col(0);
    double nearest = 0.0;
    for (const Eigen::Vector3d& d : directions) nearest = std::max(nearest, std::abs(d.dot(any)));
    CHECK(nearest > std::cos(0.2));
  }
}

TEST_CASE("level directions lie across up, and there are none without it", "[directions]") {
  const Eigen::Vector3d up = Eigen::Vector3d(1, -2, 0.5).normalized();
  const auto directions = level_directions(up, 12);
  REQUIRE(directions.size() == 12);
  for (const Eigen::Vector3d& d : directions) {
    CHECK(d.norm() == Approx(1.0));
    CHECK(d.dot(up) == Approx(0.0).margin(1e-12));
  }
  CHECK(level_directions(Eigen::Vector3d::Zero(), 12).empty());
}

TEST_CASE("passes visit all of a ranking once, every 16th first", "[directions]") {
  for (const int size : {0, 1, 15, 16, 40}) {
    std::vector<int> ranking(static_cast<std::size_t>(size)), visited;
    std::iota(ranking.begin(), ranking.end(), 0);
    visit_in_passes(ranking.begin(), ranking.end(), [&](int n) { visited.push_back(n); });
    if (size == 40)
      CHECK(std::vector(visited.begin(), visited.begin() + 4) == std::vector{0, 16, 32, 1});
    std::sort(visited.begin(), visited.end());
    CHECK(visited == ranking);
  }
}
