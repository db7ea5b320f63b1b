#include "variants/close_distance.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/quadric_points.hpp"
#include "variants/cluster_hypotheses.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("equal quadrics are close, whatever their rank, scale and sign", "[close]") {
  for (const FamilyExample& example : family_examples()) {
    CAPTURE(example.name);
    CHECK(close_distance(example.D, example.D, 0.4) < 1e-9);
    CHECK(close_distance(-3.0 * example.D, example.D, 0.4) < 1e-9);
  }
}

TEST_CASE("the close distance grows with the difference and is infinite beyond tau", "[close]") {
  const Eigen::Matrix4d unit = diagonal(1, 1, 1, -1);
  const double near = close_distance(diagonal(1, 1, 1, -1.05), unit, 0.4);
  const double farther = close_distance(diagonal(1, 1, 1, -1.2), unit, 0.4);
  CHECK(near > 0.0);
  CHECK(farther > near);
  CHECK(std::isinf(close_distance(diagonal(1, 1, 0, -1), unit, 0.4)));
}

TEST_CASE("the close distance sees what either quadric has in the other's null space", "[close]") {
  const Eigen::Matrix4d cylinder = diagonal(1, 1, 0, -1), ellipsoid = diagonal(1, 1, 0.5, -1);
  const Eigen::Matrix4d cone = diagonal(1, 1, -1, 0), hyperboloid = diagonal(1, 1, -1, -0.3);
  for (const auto& [a, b] : {std::pair(ellipsoid, cylinder), std::pair(hyperboloid, cone)}) {
    CHECK(close_distance(a, b, 10.0) > 0.9);
    CHECK(close_distance(a, b, 10.0) == close_distance(b, a, 10.0));
    CHECK(close_distance(-2.0 * a, b, 10.0) == Approx(close_distance(a, b, 10.0)));
  }
  RandomStream random(321, 0);
  const auto all = family_examples();
  for (const FamilyExample& one : all) {
    for (const FamilyExample& other : all) {
      const double there = close_distance(one.D, other.D, 10.0);
      CHECK(there == Approx(close_distance(other.D, one.D, 10.0)).margin(1e-9));
      CHECK((there < 1e-9) == (one.name == other.name));
    }
  }
}

TEST_CASE("hypotheses of one surface become one cluster, whatever their order", "[clusters]") {
  const auto sphere = [](double r2) { return diagonal(1, 1, 1, -r2); };
  const std::vector<Eigen::Matrix4d> hypotheses = {sphere(1.0), diagonal(1, 1, 0, -1), sphere(1.03),
                                                   sphere(0.98), diagonal(1, 1, 0, -1.02)};
  const auto clusters = cluster_hypotheses(hypotheses, 0.4, 0.1);
  CHECK(clusters == std::vector<std::vector<int>>{{0, 2, 3}, {1, 4}});
  std::vector<Eigen::Matrix4d> reversed(hypotheses.rbegin(), hypotheses.rend());
  CHECK(cluster_hypotheses(reversed, 0.4, 0.1) == std::vector<std::vector<int>>{{0, 3}, {1, 2, 4}});
  CHECK(cluster_hypotheses({}, 0.4, 0.1).empty());
  CHECK(cluster_hypotheses({sphere(1.0)}, 0.4, 0.1) == std::vector<std::vector<int>>{{0}});
}

TEST_CASE("a chain of hypotheses is no cluster: its ends are too far apart", "[clusters]") {
  std::vector<Eigen::Matrix4d> chain;
  for (int k = 0; k < 8; ++k) chain.push_back(diagonal(1, 1, 1, -1.0 - 0.1 * k));
  const double max_distance = close_distance(chain[0], chain[2], 0.9);
  const auto clusters = cluster_hypotheses(chain, 0.9, max_distance);
  CHECK(clusters.size() > 2);
  CHECK(clusters.size() < 8);
  for (const auto& cluster : clusters) {
    for (const int i : cluster) {
      for (const int j : cluster) {
        CHECK(close_distance(chain[static_cast<std::size_t>(i)], chain[static_cast<std::size_t>(j)],
                             0.9) <= max_distance);
      }
    }
  }
}
