#include "space/collision.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "body/pieces.hpp"
#include "grasping/clipped_surface.hpp"
#include "grasping/exact_overlap.hpp"
#include "grasping/random_box.hpp"
#include "grasping/scenes.hpp"
#include "hand/hand.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "support/catch.hpp"
#include "support/rounds.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

struct Counts {
  int queries = 0, hits = 0, missed = 0, false_alarms = 0;
};

/// Overlaps deeper than a nanometre have to be told, gaps wider than a few micrometres must not.
void judge(const ExactSolid& solid, const CollisionShape& shape, const OrientedBox& box,
           Counts& counts) {
  const bool hit = overlaps(box, shape);
  ++counts.queries;
  counts.hits += hit;
  if (!hit && solid.meets(box.inflated(-1e-9))) ++counts.missed;
  if (hit && !solid.meets(box.inflated(5e-6))) ++counts.false_alarms;
}

/// Random boxes about a shape, and boxes that touch it, a little more or less.
void query(const CollisionShape& shape, std::mt19937& random, Counts& counts) {
  const ExactSolid solid(shape);
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(0.15), p_CS = shape.X_CS.translation();
  const Eigen::AlignedBox3d near(p_CS - reach, p_CS + reach);
  for (int n = 0; n < 20; ++n) {
    judge(solid, shape, random_box(random, near), counts);
  }
  OrientedBox box = random_box(random, {p_CS, p_CS});
  const Eigen::Vector3d d = random() % 4 ? Eigen::Vector3d(random_rotation(random).col(0))
                                         : Eigen::Vector3d(shape.X_CS.linear().col(random() % 3));
  const double away = touching(solid, box, d);
  const Eigen::Vector3d start = box.p_CB;
  for (const double gap : {-1e-3, -1e-4, -1e-5, -1e-6, -1e-7, -1e-8, 1e-8, 1e-6, 2e-5, 1e-3}) {
    box.p_CB = start + (away + gap) * d;
    judge(solid, shape, box, counts);
  }
}

}  // namespace

TEST_CASE("no overlap of a box and a shape is missed, in random and touching queries",
          "[collision]") {
  std::mt19937 random(21);
  std::map<std::string, Counts> counts;
  for (const QuadricType type : all_quadric_types()) {
    if (is_imaginary(type)) continue;
    for (int n = 0; n < 15 * rounds(); ++n) {
      const ClippedSurface surface(type, random);
      for (const CollisionShape& shape : make_shapes(surface.detection())) {
        query(shape, random, counts[shape.kind]);
        if (random() % 4 == 0) break;
      }
    }
  }
  for (const auto& [kind, count] : counts) {
    INFO(kind << ": " << count.queries << " queries, " << count.hits << " hits");
    CHECK(count.missed == 0);
    CHECK(count.false_alarms == 0);
    CHECK(count.hits > 50);
  }
}

TEST_CASE("the palm keeps off the end of a target, the fingers may come close", "[collision]") {
  const OccupancyGrid nothing(Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()),
                              0.1);
  const Gripper gripper = franka_hand();
  const double top = -gripper.reach(0.03);  // the palm's front
  for (const double gap : {-0.001, 0.001, 0.004, 0.0075, 0.0085, 0.02}) {
    CAPTURE(gap);
    const double length = 0.02 - top - gap;
    Eigen::Isometry3d X_CQ = Eigen::Isometry3d::Identity();
    X_CQ.translation().z() = 0.02 - 0.5 * length;
    const Body can = make_body(cylinder_detection(X_CQ, 0.015, length)).value();
    const CollisionScene scene{ObstacleMap(nothing, false), {}, {}, make_pieces(can)};
    const SweptHand hand =
        sweep_hand(gripper, Eigen::Isometry3d::Identity(), 0.036, 0.03, 0.05);  // 3 mm beside it
    const bool meets = gap < 0.008;
    CHECK(scene.palm_obstruction(hand.palm).has_value() == meets);
    CHECK_FALSE(scene.finger_obstruction(hand));
  }
}

TEST_CASE("the clearance is the distance to the nearest thing, to within 1 mm", "[collision]") {
  const OccupancyGrid nothing(Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()),
                              0.1);
  const SweptHand hand =
      sweep_hand(franka_hand(), Eigen::Isometry3d::Identity(), 0.036, 0.03, 0.05);
  const std::vector<OrientedBox> boxes = {hand.fingers[0], hand.fingers[1], hand.palm,
                                          hand.closing[0], hand.closing[1]};
  const auto outermost = [&](const Eigen::Vector3d& d) {
    return *std::max_element(boxes.begin(), boxes.end(), [&](const auto& a, const auto& b) {
      return a.support(d) < b.support(d);
    });
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  for (const double below : {0.0015, 0.011, 0.025, 0.1}) {
    for (const double beside : {0.004, 0.0155, 0.03, 0.2}) {
      CAPTURE(below, beside);
      SupportPlane plane;
      plane.X_CP.linear() = Eigen::AngleAxisd(M_PI, x).toRotationMatrix();  // upwards is −z
      plane.X_CP.translation() = (outermost(z).support(z) + below) * z;
      plane.extent_P = {Eigen::Vector2d::Constant(-1.0), Eigen::Vector2d::Constant(1.0)};
      Eigen::Vector3d point = outermost(x).p_CB;
      point.x() = outermost(x).support(x) + beside;
      CollisionScene scene{ObstacleMap(nothing, false), {plane}, {}, {}};
      scene.other_points = ObstaclePoints({point});
      const double expected = std::min({below, beside, kMaxClearance}), rounding = 1e-6;
      CHECK(scene.clearance(hand) <= expected + rounding);
      CHECK(scene.clearance(hand) > expected - 0.001 - rounding);
    }
  }
}

TEST_CASE("a hand keeps off a noisy plane as far as voxels gave way to it",
          "[collision][support]") {
  const OccupancyGrid nothing(Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()),
                              0.1);
  const SweptHand hand =
      sweep_hand(franka_hand(), Eigen::Isometry3d::Identity(), 0.036, 0.03, 0.05);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  // The least is 2 mm and the most is 6 mm; if no voxel gave way, voxels keep the hand off.
  const auto [rms, gave_way, off] = GENERATE(table<double, bool, double>({{0.0, true, 0.002},
                                                                          {0.001, true, 0.003},
                                                                          {0.002, true, 0.006},
                                                                          {0.1, true, 0.006},
                                                                          {0.002, false, 0.002}}));
  CAPTURE(rms, gave_way);
  SupportPlane plane;
  plane.X_CP.linear() = Eigen::AngleAxisd(M_PI, x).toRotationMatrix();  // upwards is −z
  plane.extent_P = {Eigen::Vector2d::Constant(-1.0), Eigen::Vector2d::Constant(1.0)};
  plane.rms = rms, plane.gave_way = gave_way;
  const auto obstruction = [&](double below) {
    plane.X_CP.translation() = (hand.fingers[0].support(z) + below) * z;
    const CollisionScene scene{ObstacleMap(nothing, false), {plane}, {}, {}};
    return scene.finger_obstruction(hand);
  };
  CHECK(obstruction(off - 1e-4) == Obstruction::kSupport);
  CHECK_FALSE(obstruction(off + 1e-4));
}
