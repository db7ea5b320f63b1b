#include "hand/reachable_places.hpp"

#include <random>

#include "support/catch.hpp"

namespace quadrille {
namespace {

using Places = Eigen::AlignedBox3d;

double between(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

Eigen::Vector3d place_in(std::mt19937& random, const Places& box) {
  Eigen::Vector3d p;
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = between(random, box.min()[axis], box.max()[axis]);
  }
  return p;
}

const Places kAround(Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0));

struct Query {
  Reach reach;
  Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
  Places places_G;
};

/// @param size  largest size of the box of places [m]
Query random_query(std::mt19937& random, double size) {
  Query query;
  query.reach.base_C = place_in(random, kAround);
  query.reach.min = between(random, 0.0, 1.0);
  query.reach.max = query.reach.min + between(random, 0.0, 0.5);
  const Eigen::Vector3d axis = place_in(random, kAround).normalized();
  query.X_CG = Eigen::Translation3d(place_in(random, kAround)) *
               Eigen::AngleAxisd(between(random, 0.0, 3.0), axis);
  const Eigen::Vector3d corner = place_in(random, kAround);
  query.places_G =
      Places(corner, corner + 0.5 * size * (place_in(random, kAround).array() + 1.0).matrix());
  return query;
}

}  // namespace

TEST_CASE("a box with a place that the arm reaches is never refused", "[reach]") {
  std::mt19937 random(7);
  int refused = 0, taken = 0;
  for (int n = 0; n < 2000; ++n) {
    const auto [reach, X_CG, places_G] = random_query(random, 0.3);
    bool any = false, any_with_way = false;
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector3d p_G = place_in(random, places_G);
      const bool there = reach.contains(X_CG * p_G);
      any |= there;
      any_with_way |= there && reach.contains(X_CG * (p_G - 0.1 * Eigen::Vector3d::UnitZ()));
    }
    const bool may = may_reach(reach, X_CG, places_G);
    const bool may_with_way = may_approach(reach, X_CG, places_G, 0.1);
    CHECK((may || !any));
    CHECK((may_with_way || !any_with_way));
    CHECK((may || !may_with_way));
    ++(may_with_way ? taken : refused);
  }
  // Neither answer is given always.
  CHECK(refused > 200);
  CHECK(taken > 200);
}

TEST_CASE("of a single place it is known exactly whether the arm reaches it", "[reach]") {
  std::mt19937 random(8);
  int yes = 0, no = 0;
  for (int n = 0; n < 2000; ++n) {
    const auto [reach, X_CG, places_G] = random_query(random, 0.0);
    const Eigen::Vector3d p_C = X_CG * places_G.min();
    const Eigen::Vector3d before_C = p_C - 0.2 * X_CG.linear().col(2);
    // Rounding decides nothing here.
    const auto is_near_a_bound = [&, r = reach](const Eigen::Vector3d& p) {
      const double distance = (p - r.base_C).norm();
      return std::abs(distance - r.min) < 1e-9 || std::abs(distance - r.max) < 1e-9;
    };
    if (is_near_a_bound(p_C) || is_near_a_bound(before_C)) continue;
    CHECK(may_reach(reach, X_CG, places_G) == reach.contains(p_C));
    const bool both = reach.contains(p_C) && reach.contains(before_C);
    CHECK(may_approach(reach, X_CG, places_G, 0.2) == both);
    ++(both ? yes : no);
  }
  CHECK(yes > 50);
  CHECK(no > 50);
}

}  // namespace quadrille
