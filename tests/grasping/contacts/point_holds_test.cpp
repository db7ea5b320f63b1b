#include "contacts/point_holds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kMaxFriction = 0.42;
const Eigen::Vector3d kTowardsSky = Eigen::Vector3d(0, -1, -1).normalized();

/// A sensor at the origin looks at things around (0, 0, 0.7), on a support that rises towards it.
ApproachSpace space_around(const Eigen::Vector3d& centre) {
  ApproachSpace space;
  space.up_C = kTowardsSky;
  space.view_C = -centre.normalized();
  space.centre_C = centre;
  space.axes_C << Eigen::Vector3d::UnitX(), kTowardsSky.cross(Eigen::Vector3d::UnitX()),
      kTowardsSky;
  return space;
}

void add_ball(const Ball& ball, SurfacePoints* points) {
  const int count = static_cast<int>(4.0 * std::numbers::pi * ball.radius * ball.radius / 6e-6);
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, t = 2.399963 * i, r = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d n(r * std::cos(t), r * std::sin(t), z);
    const Eigen::Vector3d p = ball.p_C + ball.radius * n;
    if (n.dot(p) > 0.0) continue;
    points->p_C.push_back(p);
    points->n_C.push_back(n);
  }
}

std::vector<char> all_own(const SurfacePoints& points) {
  return std::vector<char>(points.p_C.size(), 1);
}

}  // namespace

TEST_CASE("a ball without a name is held across its width", "[contacts][points]") {
  const Ball ball{Eigen::Vector3d(0.0, 0.0, 0.7), 0.03};
  SurfacePoints points;
  add_ball(ball, &points);
  const auto holds =
      point_holds(points, all_own(points), franka_hand(), space_around(ball.p_C), {}, kMaxFriction);
  REQUIRE(holds.size() > 20);
  bool full = false;
  for (const Hold& hold : holds) {
    const ContactLine& line = hold.line;
    CHECK(hold.friction <= kMaxFriction);
    CHECK(hold.evidence.seen >= 0.5);
    CHECK(line.width <= 2.0 * ball.radius + 1e-9);
    CHECK(line.width ==
          Approx((line.contacts_C[0] - line.contacts_C[1]).dot(line.closing_C)).margin(1e-9));
    CHECK(std::abs(line.closing_C.dot(hold.approach_C)) < 1e-9);
    full |= line.width > 2.0 * ball.radius - 0.002 && hold.evidence.seen == 1.0;
  }
  CHECK(full);
}

TEST_CASE("a search that may go on finds the same holds, and one that may not fewer of them",
          "[contacts][points]") {
  SurfacePoints points;
  add_ball({Eigen::Vector3d(0.0, 0.0, 0.7), 0.03}, &points);
  const auto search = [&](const GoesOn& goes_on) {
    return point_holds(points, all_own(points), franka_hand(), space_around({0.0, 0.0, 0.7}), {},
                       kMaxFriction, goes_on);
  };
  const auto is_same = [](const Hold& a, const Hold& b) {
    return a.line.centre_C == b.line.centre_C && a.approach_C == b.approach_C;
  };
  const std::vector<Hold> all = search({});
  std::vector<std::size_t> asked;
  const std::vector<Hold> also = search([&](int rounds, std::span<const Hold> found) {
    CHECK(rounds == static_cast<int>(asked.size()) + 1);
    asked.push_back(found.size());
    return true;
  });
  REQUIRE(asked.size() == kHoldRounds - 1);
  CHECK(std::equal(all.begin(), all.end(), also.begin(), also.end(), is_same));
  const std::vector<Hold> some = search([](int, std::span<const Hold>) { return false; });
  CHECK(some.size() == asked[0]);
  CHECK(some.size() < all.size());
  for (const Hold& hold : some) {
    CHECK(std::any_of(all.begin(), all.end(), [&](const Hold& h) { return is_same(h, hold); }));
  }
}

TEST_CASE("where nothing is the target's own, nothing is held", "[contacts][points]") {
  SurfacePoints points;
  add_ball({Eigen::Vector3d(0.0, 0.0, 0.7), 0.03}, &points);
  const ApproachSpace space = space_around({0.0, 0.0, 0.7});
  CHECK(point_holds(points, std::vector<char>(points.p_C.size(), 0), franka_hand(), space, {},
                    kMaxFriction)
            .empty());
  CHECK(point_holds({}, {}, franka_hand(), space, {}, kMaxFriction).empty());
}

TEST_CASE("things with room for a finger between them are held one by one, or both at once",
          "[contacts][points]") {
  const double radius = 0.012, apart = 0.05;
  SurfacePoints points;
  add_ball({Eigen::Vector3d(-0.5 * apart, 0.0, 0.7), radius}, &points);
  const auto own = points.p_C.size();
  add_ball({Eigen::Vector3d(0.5 * apart, 0.0, 0.7), radius}, &points);
  std::vector<char> first(points.p_C.size(), 0);
  std::fill_n(first.begin(), own, 1);
  const auto holds = point_holds(points, first, franka_hand(),
                                 space_around({-0.5 * apart, 0.0, 0.7}), {}, kMaxFriction);
  int alone = 0, together = 0;
  for (const Hold& hold : holds) {
    if (std::abs(hold.line.closing_C.x()) < 0.95) continue;
    (hold.line.width < 2.0 * radius + 0.001 ? alone : together) += 1;
    if (hold.line.width > 2.0 * radius + 0.001) CHECK(hold.line.width > apart);
  }
  CHECK(alone > 0);
  CHECK(together > 0);
}

TEST_CASE("what is wider than the hand is not held", "[contacts][points]") {
  const Ball ball{Eigen::Vector3d(0.0, 0.0, 0.7), 0.06};
  SurfacePoints points;
  add_ball(ball, &points);
  Gripper small = franka_hand();
  small.max_opening = 0.03;
  for (const Hold& hold :
       point_holds(points, all_own(points), small, space_around(ball.p_C), {}, kMaxFriction)) {
    CHECK(hold.line.width <= 0.03);
  }
}

namespace {

/// One side of a wall 3 mm thick that faces the sensor and stands up to a height, with its upper
/// edge; below the first 10 mm it leans by the given slope, as a solid does below its edge.
SurfacePoints wall_seen_in_front(double slope, double height = 0.04) {
  SurfacePoints points;
  const Eigen::Vector3d n = -Eigen::Vector3d::UnitZ().cross(kTowardsSky).cross(kTowardsSky);
  const Eigen::Vector3d outwards = -n.normalized(), top(0.0, 0.0, 0.7);
  for (double x = -0.03; x <= 0.03; x += 0.0025) {
    for (double h = 0.0; h < height; h += 0.0025) {
      const double out = slope * std::max(0.0, h - 0.01);
      points.p_C.push_back(top + Eigen::Vector3d(x, 0.0, 0.0) - h * kTowardsSky + out * outwards);
      points.n_C.push_back(outwards);
    }
    points.p_C.push_back(top + Eigen::Vector3d(x, 0.0, 0.0) - 0.003 * outwards);
    points.n_C.push_back(kTowardsSky);
  }
  return points;
}

/// The number of holds across the wall from above.
/// @param reach  the least depth of the tips below the upper edge [m]
int thin_holds(const SurfacePoints& points, bool free_behind, double reach = 0.0) {
  const Eigen::Vector3d outwards = points.n_C.front();
  // Only space behind the wall is free: on the side that the sensor did not see.
  const Eigen::Vector3d top(0.0, 0.0, 0.7);
  const ThinWalls walls{0.005, 0.008, [&](const Eigen::Vector3d& p) {
                          return free_behind && (p - top).dot(outwards) < -0.003;
                        }};
  const auto holds = point_holds(points, all_own(points), franka_hand(),
                                 space_around({0.0, 0.0, 0.7}), walls, kMaxFriction);
  int count = 0;
  for (const Hold& hold : holds) {
    const bool from_above = hold.approach_C.dot(kTowardsSky) < -0.9;
    const bool across = std::abs(hold.line.closing_C.dot(outwards)) > 0.9;
    const Eigen::Vector3d tips = hold.line.centre_C + franka_hand().finger_front * hold.approach_C;
    const bool deep = (top - tips).dot(kTowardsSky) > reach;
    if (!from_above || !across || !deep || hold.line.width > 0.008) continue;
    CHECK(hold.guessed);
    CHECK(hold.line.opening == Approx(0.008));
    // Only the hidden side was moved to make the wall as thick as the thinnest one.
    CHECK(hold.line.width == Approx(0.005));
    const auto& contacts = hold.line.contacts_C;
    CHECK(std::max((contacts[0] - top).dot(outwards), (contacts[1] - top).dot(outwards)) ==
          Approx(0.0).margin(1e-6));
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("a wall seen on one side is held if space behind its rim was seen to be free",
          "[contacts][points]") {
  CHECK(thin_holds(wall_seen_in_front(0.0), true) > 0);
  CHECK(thin_holds(wall_seen_in_front(0.0), false) == 0);
}

TEST_CASE("a high wall is held deep", "[contacts][points]") {
  CHECK(thin_holds(wall_seen_in_front(0.0, 0.07), true, 0.7 * franka_hand().finger.z()) > 0);
}

TEST_CASE("the edge of a surface that bends away below it is no thin wall", "[contacts][points]") {
  CHECK(thin_holds(wall_seen_in_front(2.0), true) == 0);
}

TEST_CASE("tips stop above what a thing that lies flat stands on", "[contacts][points]") {
  // A bar of 12 x 13 x 120 mm, whose top and two long sides are known.
  const Eigen::Vector3d centre(0.0, 0.0, 0.7), along = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d across = kTowardsSky.cross(along);
  SurfacePoints points;
  for (double x = -0.06; x <= 0.06; x += 0.0025) {
    for (double s = -0.006; s <= 0.006; s += 0.002) {
      const std::pair<Eigen::Vector3d, Eigen::Vector3d> sides[] = {
          {s * across + 0.0065 * kTowardsSky, kTowardsSky},
          {0.006 * across + s * kTowardsSky, across},
          {-0.006 * across + s * kTowardsSky, -across}};
      for (const auto& [offset, normal] : sides) {
        points.p_C.push_back(centre + x * along + offset);
        points.n_C.push_back(normal);
      }
    }
  }
  // The bar may be turned about its length, so that the hand leans to one side.
  const double turn = GENERATE(0.0, 0.02, 0.04);
  const Eigen::Vector3d up = Eigen::AngleAxisd(turn, along) * kTowardsSky;
  const Gripper hand = franka_hand();
  ApproachSpace space = space_around(centre);
  space.up_C = up, space.height = 0.0065, space.off_support = 0.002;
  int steep = 0, leaning = 0;
  for (const Hold& hold : point_holds(points, all_own(points), hand, space, {}, kMaxFriction)) {
    const Eigen::Vector3d& closing = hold.line.closing_C;
    const double aslant = std::abs(closing.dot(up));
    if (aslant > 0.05 || hold.approach_C.dot(up) > -0.5) continue;
    const Eigen::Vector3d tip = hold.line.centre_C + hand.finger_front * hold.approach_C;
    const double lean = std::abs(closing.cross(hold.approach_C).dot(up));
    const double lowest = (tip - centre).dot(up) - 0.5 * hand.finger.x() * lean -
                          aslant * (0.5 * hand.max_opening + hand.finger.y());
    CHECK(lowest + space.height > 0.002);
    CHECK(lowest < 0.0065);
    ++steep;
    leaning += aslant > 0.5 * turn;
  }
  CHECK(steep > 5);
  CHECK((turn == 0.0 || leaning > 0));
}
