#include "contacts/tip_holds.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "body/pieces.hpp"
#include "grasping/exact_overlap.hpp"
#include "grasping/scenes.hpp"
#include "hand/hand.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/shape.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

const Eigen::Vector3d kUpwards = Eigen::Vector3d(0, -1, -1).normalized();

ApproachSpace space_above(const Body& body) {
  ApproachSpace space;
  space.axes_C = body.X_CQ.linear();
  space.centre_C = body.centre_C();
  space.up_C = kUpwards;
  return space;
}

SupportPlane table() {
  const Detection d = table_detection();
  return {d.X_CQ, {d.extent_Q.min().head<2>(), d.extent_Q.max().head<2>()}};
}

/// Nothing in the way but planes.
CollisionScene only(std::vector<SupportPlane> planes) {
  return {
      ObstacleMap(OccupancyGrid(Eigen::AlignedBox3d(), 0.005), false), std::move(planes), {}, {}};
}

/// As wide as the hand, on the table: it cannot be held across its middle.
Detection flat_ellipsoid(double b = 0.037) {
  Detection d;
  d.id = 1;
  d.type = QuadricType::kEllipsoid;
  d.X_CQ = table_detection().X_CQ;
  d.X_CQ.translate(Eigen::Vector3d(0.0, 0.0, 0.032));
  const Eigen::Vector3d semi(0.048, b, 0.032);
  d.dimensions = {{"a", semi.x(), 0.0}, {"b", semi.y(), 0.0}, {"c", semi.z(), 0.0}};
  d.extent_Q = {-semi, semi};
  d.score = 1.0;
  return d;
}

/// The table with the body on it, as the camera at the origin sees it.
PointCloud render_on_table(const Body& body) {
  PointCloud cloud = render(std::vector<Ball>{});
  for (std::size_t n = 0; n < cloud.points.size(); ++n) {
    const int u = static_cast<int>(n) % kWidth, v = static_cast<int>(n) / kWidth;
    const auto through = chord(body, Eigen::Vector3d::Zero(), pixel_ray(u, v).normalized());
    if (!through) continue;
    const Eigen::Vector3d &a = through->contacts_C[0], &b = through->contacts_C[1];
    cloud.points[n] = (a.z() < b.z() ? a : b).cast<float>();
  }
  return cloud;
}

}  // namespace

TEST_CASE("a search by the tips ends early only if nothing that it found is promising",
          "[contacts][tips]") {
  const Body body = make_body(flat_ellipsoid()).value();
  const CollisionScene scene = only({});
  const Gripper hand = franka_hand();
  const auto search = [&](const std::function<bool(const Hold&)>& is_promising) {
    TipLimits limits{scene, 0.1, 0.4};
    limits.is_promising = is_promising;
    return tip_holds(body, hand, space_above(body), limits);
  };
  const auto is_same = [](const Hold& a, const Hold& b) {
    return a.line.centre_C == b.line.centre_C && a.approach_C == b.approach_C;
  };
  const std::vector<Hold> all = search({});
  const std::vector<Hold> also = search([](const Hold&) { return true; });
  const std::vector<Hold> some = search([](const Hold&) { return false; });
  REQUIRE(all.size() > 100);
  CHECK(std::equal(all.begin(), all.end(), also.begin(), also.end(), is_same));
  CHECK_FALSE(some.empty());
  CHECK(some.size() < all.size());
}

TEST_CASE("holds by the tips touch the body, need no more friction than asked for, and repeat",
          "[tips]") {
  std::mt19937 random(71);
  const CollisionScene scene = only({});
  std::vector<QuadricType> leaning;  // everywhere, too far for any hold
  for (Detection d : solid_detections()) {
    if (d.type == QuadricType::kParallelPlanes) continue;
    CAPTURE(to_string(d.type));
    d.X_CQ = random_pose(random);
    const Body body = make_body(d).value();
    const auto holds = tip_holds(body, franka_hand(), space_above(body), {scene, 0.05, 0.4});
    if (holds.empty()) {
      leaning.push_back(d.type);
      continue;
    }
    REQUIRE(holds.size() > 20);
    for (const Hold& hold : holds) {
      REQUIRE(hold.friction <= 0.4);
      REQUIRE(hold.line.width <= franka_hand().max_opening);
      REQUIRE(hold.approach_C.dot(hold.line.closing_C) == Approx(0.0).margin(1e-9));
      REQUIRE(reachable(hold.approach_C, space_above(body)));
      for (const Eigen::Vector3d& p_C : hold.line.contacts_C) {
        REQUIRE(body.contains(p_C, 1e-6));
        REQUIRE_FALSE(body.contains(p_C, -1e-4));
      }
    }
    const auto again = tip_holds(body, franka_hand(), space_above(body), {scene, 0.05, 0.4});
    REQUIRE(again.size() == holds.size());
    CHECK(again.front().line.centre_C == holds.front().line.centre_C);
    CHECK(again.back().line.centre_C == holds.back().line.centre_C);
  }
  CHECK(leaning == std::vector{QuadricType::kHyperboloidTwoSheets});
}

TEST_CASE("what needs little friction comes before what needs much", "[tips]") {
  const Body body = make_body(flat_ellipsoid()).value();
  const auto holds = tip_holds(body, franka_hand(), space_above(body), {only({}), 0.05, 0.5});
  REQUIRE(holds.size() > 100);
  const auto band = [](const Hold& hold) { return std::max(0.3, hold.friction); };
  for (std::size_t n = 1; n < holds.size(); ++n) {
    REQUIRE(band(holds[n]) > band(holds[n - 1]) - 0.1 - 1e-9);
  }
}

TEST_CASE("no hold lies far below the plane that the body stands on", "[tips]") {
  const Body body = make_body(flat_ellipsoid()).value();
  const auto anywhere = tip_holds(body, franka_hand(), space_above(body), {only({}), 0.05, 0.5});
  const auto above =
      tip_holds(body, franka_hand(), space_above(body), {only({table()}), 0.05, 0.5});
  REQUIRE_FALSE(above.empty());
  CHECK(above.size() < anywhere.size());
  for (const Hold& hold : above) {
    const Eigen::Vector3d tips_C =
        hold.line.centre_C + franka_hand().finger_front * hold.approach_C;
    CHECK(table().distance(tips_C) > -0.0051);
  }
}

TEST_CASE("what is wider than the hand opens is planned to be held by the tips, clear of all else",
          "[tips][plan]") {
  const Detection ellipsoid = flat_ellipsoid(0.04);
  const Body body = make_body(ellipsoid).value();
  const Gripper hand = franka_hand();
  PlanOptions options;
  options.unknown = UnknownPolicy::kFree;
  const GraspPlan plan =
      plan_grasps(render_on_table(body), {table_detection(), ellipsoid}, hand, options);
  REQUIRE(plan.grasps.size() > 0);
  CHECK(plan.grasps.size() <= 8);  // across its middle it would be more
  const std::vector<CollisionShape> shapes = make_shapes(ellipsoid);
  const ExactSolid solid(shapes.front());
  for (const Grasp& grasp : plan.grasps) {
    CHECK(grasp.friction_needed <= options.friction);
    const SweptHand swept =
        sweep_hand(hand, grasp.X_CG, grasp.preshape, grasp.width, grasp.approach);
    for (const OrientedBox& box : {swept.fingers[0], swept.fingers[1], swept.palm}) {
      CHECK_FALSE(solid.meets(box));
      CHECK(-box.support(-kUpwards) > kUpwards.dot(table().X_CP.translation()));
    }
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector3d p_G = grasp.X_CG.inverse() * grasp.contacts_C[i];
      CHECK(p_G.y() == Approx((i == 0 ? 0.5 : -0.5) * grasp.width).margin(1e-5));
      CHECK(p_G.z() <= hand.finger_front + 1e-9);
      CHECK(p_G.z() > hand.finger_front - 0.01);  // near the tips
      CHECK(body.contains(grasp.contacts_C[i], 1e-6));
      CHECK_FALSE(body.contains(grasp.contacts_C[i], -1e-4));
    }
  }
}

TEST_CASE("a body nearly as wide as the hand opens can be held by the tips", "[tips]") {
  const Body body = make_body(flat_ellipsoid()).value();
  const Gripper hand = franka_hand();
  const OccupancyGrid nothing(Eigen::AlignedBox3d(), 0.005);
  const CollisionScene scene{ObstacleMap(nothing, false), {table()}, {}, make_pieces(body)};
  int free = 0;
  for (const Hold& hold : tip_holds(body, hand, space_above(body), {scene, 0.05, 0.5})) {
    const Eigen::Isometry3d X_CG = grasp_pose(hold.line, hold.approach_C, 0.0);
    const SweptHand swept = sweep_hand(hand, X_CG, hand.max_opening, hold.line.width, 0.05);
    if (scene.palm_obstruction(swept.palm) || scene.finger_obstruction(swept)) continue;
    ++free;
  }
  CHECK(free > 0);
}
