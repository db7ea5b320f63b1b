// What is asked of a plan, on a table with three balls and a can.
#include "quadrille/grasping/grasp_query.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <thread>
#include <utility>

#include "grasping/plans.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/grasping/rigid_motion.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

/// A can and three balls of growing size on a table, with the detections that are the truth.
struct AskedScene {
  Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.5, 0.5});
  std::vector<Detection> detections;
  PointCloud cloud;

  AskedScene() {
    const Eigen::Isometry3d X_CQ = X_CW * test::translation(-0.15, 0.0, 0.05);
    std::vector<test::Patch> patches = test::can(X_CQ, 0.03, 0.1);
    patches.push_back(test::rectangle(X_CW, 1.2, 1.0));
    detections.push_back(test::cylinder_detection(X_CQ, 0.03, 0.1, 1));
    detections.back().track = 31;
    for (int k = 0; k < 3; ++k) {
      const double radius = 0.02 + 0.005 * k;
      const Eigen::Isometry3d X = X_CW * test::translation(0.12 * k, 0.0, radius);
      patches.push_back(test::sphere(X, radius));
      detections.push_back(test::sphere_detection({X.translation(), radius}, 2 + k));
      detections.back().track = 32 + k;
    }
    Detection table = test::table_detection();
    table.X_CQ = X_CW;
    detections.push_back(table);
    cloud = test::render(patches, {640, 480, 1.0 / 600.0, 0.0005});
  }
};

const AskedScene& scene() {
  static const AskedScene asked;
  return asked;
}

const GraspScene& ready() {
  static const GraspScene made(scene().cloud, scene().detections, franka_hand());
  return made;
}

using test::targets_of;

std::set<int> targets_of(const GraspQuery& query) { return targets_of(ready().plan(query)); }

Eigen::Vector3d in_C(double x, double y, double z) {
  return scene().X_CW * Eigen::Vector3d(x, y, z);
}

}  // namespace

TEST_CASE("a scene that is asked for everything answers as a plan does", "[query]") {
  const GraspPlan asked = ready().plan(),
                  planned = plan_grasps(scene().cloud, scene().detections, franka_hand());
  REQUIRE(targets_of(asked) == std::set{1, 2, 3, 4});
  test::check_same_grasps(asked, planned);
  for (const Grasp& grasp : asked.grasps) CHECK(grasp.track == 30 + grasp.target);
  CHECK(asked.rejected == planned.rejected);
}

TEST_CASE("only what is asked for is grasped, as it is when all is", "[query]") {
  GraspQuery query;
  query.ids = {3, 1};
  CHECK(targets_of(query) == std::set{1, 3});
  query = {};
  query.tracks = {34};
  CHECK(targets_of(query) == std::set{4});
  query = {};
  query.types = {QuadricType::kSphere};
  CHECK(targets_of(query) == std::set{2, 3, 4});
  query.min_size = 0.045;
  CHECK(targets_of(query) == std::set{3, 4});
  query.max_size = 0.055;
  CHECK(targets_of(query) == std::set{3});
  // A grasp on the target alone is one of those that are planned on it among all.
  const GraspPlan some = ready().plan(query), all = ready().plan();
  for (const Grasp& grasp : some.grasps) {
    CHECK(std::any_of(all.grasps.begin(), all.grasps.end(), [&](const Grasp& other) {
      return other.X_CG.isApprox(grasp.X_CG, 0.0) && other.score == grasp.score;
    }));
  }
}

TEST_CASE("what lies in a region, and what is nearest to a point", "[query]") {
  GraspQuery query;
  // In the world's axes, which are slanted to the cloud's.
  query.region =
      Region{scene().X_CW, {Eigen::Vector3d(0.06, -0.1, 0.0), Eigen::Vector3d(0.5, 0.1, 0.2)}};
  CHECK(targets_of(query) == std::set{3, 4});
  query.near_C = in_C(0.1, 0.0, 0.0);
  CHECK(targets_of(query) == std::set{3});
  // The nearest of those in the region, not of all.
  query.near_C = in_C(-0.3, 0.0, 0.0);
  CHECK(targets_of(query) == std::set{3});
  query.region.reset();
  CHECK(targets_of(query) == std::set{1});
  const Eigen::Isometry3d X_FC = test::translation(1, 2, 3) * scene().X_CW.inverse();
  const GraspQuery there = moved(query, X_FC), back = moved(there, X_FC.inverse());
  CHECK((*there.near_C - Eigen::Vector3d(0.7, 2, 3)).norm() < 1e-12);
  CHECK(targets_of(back) == std::set{1});
}

TEST_CASE("the hand comes within the cone that is asked for", "[query]") {
  const Eigen::Vector3d down = -scene().X_CW.linear().col(2);
  const Eigen::Vector3d slanted = (down + scene().X_CW.linear().col(1)).normalized();
  for (const Eigen::Vector3d& axis : {down, slanted}) {
    for (const double angle : {0.15, 0.5}) {
      GraspQuery query;
      query.approach = Cone{axis, angle};
      const GraspPlan plan = ready().plan(query);
      CHECK(targets_of(plan).size() >= 3);
      for (const Grasp& grasp : plan.grasps) {
        CHECK(grasp.X_CG.linear().col(2).dot(axis) > std::cos(angle) - 1e-9);
      }
      CHECK(plan.rejected.at("approach") > 0);
    }
  }
}

TEST_CASE("a cone holds all directions at 180°, and few at a tiny angle", "[query]") {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  const Cone all{axis, std::numbers::pi}, few{axis, 1e-4};
  CHECK(all.contains(-axis));
  CHECK(few.contains(axis * (1.0 - 1e-7)));
  CHECK_FALSE(few.contains((axis + 2e-4 * axis.unitOrthogonal()).normalized()));
}

TEST_CASE("clearance and number are kept", "[query]") {
  GraspQuery query;
  query.min_clearance = 0.008;
  const GraspPlan plan = ready().plan(query);
  REQUIRE_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps) CHECK(grasp.clearance >= 0.008);
  CHECK(plan.rejected.at("clearance") > 0);
  query = {};
  query.max_grasps = 3;
  CHECK(ready().plan(query).grasps.size() == 3);
  CHECK(targets_of(query).size() == 3);
}

TEST_CASE("a query that nothing meets is told why", "[query]") {
  const auto why = [](const GraspQuery& query) {
    const GraspPlan plan = ready().plan(query);
    CHECK(plan.grasps.empty());
    return plan.warnings.back();
  };
  GraspQuery query;
  query.ids = {77};
  CHECK(why(query) == "no target of that id; there are: 1 2 3 4");
  CHECK(ready().plan(query).warnings.at(0) == "target 77 was not found");
  query.ids = {100};
  CHECK(ready().plan(query).warnings.at(0) == "target 100 is a plane");
  // Said also where others are found.
  query.ids = {77, 2};
  CHECK(ready().plan(query).warnings == std::vector<std::string>{"target 77 was not found"});
  query.ids = {2};
  query.min_size = 0.3;
  CHECK(why(query) == "no target of that size; there are: 2");
  query = {};
  query.tracks = {2};
  CHECK(why(query) == "no target of that track; there are the tracks: 31 32 33 34");
  query.ids = {3, 1};
  CHECK(why(query) == "no target of that track; there are the tracks: 31 33");
  // A ball that the hand cannot span.
  std::vector<Detection> detections = scene().detections;
  detections.push_back(test::sphere_detection({in_C(0.0, 0.3, 0.2), 0.2}, 9));
  const GraspScene with_large(scene().cloud, detections, franka_hand());
  query = {};
  query.ids = {9};
  CHECK(with_large.plan(query).warnings.at(0) == "target 9 cannot be held: width");
}

TEST_CASE("all parts of a body are one target, unless a query names a part", "[query][bodies]") {
  SceneBody stack;
  stack.id = 1;
  stack.kind = BodyKind::kRevolution;
  stack.parts = {1, 2};
  stack.track = 50;
  const GraspScene apart(scene().cloud, scene().detections, franka_hand());
  const GraspScene made(scene().cloud, scene().detections, franka_hand(), {}, {}, {}, {stack});
  const auto outcome_of = [](const GraspPlan& plan, int id) {
    const auto found = std::find_if(plan.targets.begin(), plan.targets.end(),
                                    [&](const TargetOutcome& o) { return o.target == id; });
    REQUIRE(found != plan.targets.end());
    return *found;
  };
  const GraspPlan two = apart.plan(), one = made.plan();
  CHECK(targets_of(one) == std::set{1, 3, 4});
  CHECK(one.targets.size() + 1 == two.targets.size());
  // The can and the ball are far from each other, so that none of their grasps are alike.
  const TargetOutcome can = outcome_of(two, 1), ball = outcome_of(two, 2);
  CHECK(outcome_of(one, 1).grasps == can.grasps + ball.grasps);
  for (const auto& [why, count] : outcome_of(one, 1).refusals) {
    const auto in = [&](const TargetOutcome& o) {
      const auto found = o.refusals.find(why);
      return found == o.refusals.end() ? 0 : found->second;
    };
    CHECK(count == in(can) + in(ball));
  }
  for (const Grasp& grasp : one.grasps) CHECK(grasp.track == 30 + grasp.target);
  GraspQuery query;
  query.ids = {2};
  CHECK(targets_of(made.plan(query)) == std::set{2});
  // Whoever names the body too gets all of it.
  query.ids = {1, 2};
  CHECK(outcome_of(made.plan(query), 1).grasps == outcome_of(one, 1).grasps);
  query = {};
  query.tracks = {32};
  CHECK(targets_of(made.plan(query)) == std::set{2});
  query.tracks = {31};
  CHECK(outcome_of(made.plan(query), 1).grasps == outcome_of(one, 1).grasps);
  // Whoever asks for what is nearest to a part gets the whole body.
  query = {};
  query.near_C = scene().X_CW * Eigen::Vector3d(0.0, 0.0, 0.02);
  CHECK(outcome_of(made.plan(query), 1).grasps == outcome_of(one, 1).grasps);
  query = {};
  query.per_target = 2;
  const GraspPlan few = made.plan(query);
  CHECK(std::count_if(few.grasps.begin(), few.grasps.end(),
                      [](const Grasp& grasp) { return grasp.target == 1; }) == 2);
}

TEST_CASE("the track of a body asks for all that is part of it", "[query][bodies]") {
  SceneBody stack, ball, lump;
  stack.id = 1;
  stack.kind = BodyKind::kRevolution;
  stack.parts = {1, 2};
  stack.track = 50;
  ball.id = 3;
  ball.parts = {3};
  ball.track = 51;
  lump.id = 7;
  lump.kind = BodyKind::kLump;
  lump.X_CB = scene().X_CW * test::translation(0.0, 0.25, 0.02);
  lump.size = {0.03, 0.03, 0.04};
  lump.track = 52;
  const GraspScene made(scene().cloud, scene().detections, franka_hand(), {}, {}, {},
                        {stack, ball, lump});
  GraspQuery query;
  query.tracks = {50};
  CHECK(targets_of(made.plan(query)) == std::set{1});
  query.tracks = {51, 31};
  const GraspPlan both = made.plan(query);
  CHECK(targets_of(both) == std::set{1, 3});
  // A quadric's grasp has the quadric's own track.
  for (const Grasp& grasp : both.grasps) CHECK(grasp.track == 30 + grasp.target);
  query.tracks = {52};
  const GraspPlan none = made.plan(query);
  REQUIRE(none.targets.size() == 1);
  CHECK(none.targets[0].target == 7);
  query.tracks = {2};
  CHECK(made.plan(query).warnings.back() ==
        "no target of that track; there are the tracks: 31 32 33 34 50 51 52");
}

TEST_CASE("who asks for tracks where nothing has one is told so", "[query]") {
  std::vector<Detection> detections = scene().detections;
  for (Detection& detection : detections) detection.track = 0;
  GraspQuery query;
  query.tracks = {2};
  const GraspScene untracked(scene().cloud, detections, franka_hand());
  CHECK(untracked.plan(query).warnings.back() ==
        "no target of that track; none of the targets has a track");
}

TEST_CASE("a query that is out of range names its field", "[query]") {
  static const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, void (*)(GraspQuery&)> spoiled[] = {
      {"min_size = ", [](GraspQuery& q) { q.min_size = nan; }},
      {"max_size = ", [](GraspQuery& q) { q.max_size = -1.0; }},
      {"min_clearance = ", [](GraspQuery& q) { q.min_clearance = 1.0; }},
      {"near = ", [](GraspQuery& q) { q.near_C = Eigen::Vector3d(0, 0, nan); }},
      {"approach = ",
       [](GraspQuery& q) {
         q.approach = Cone{{0, 0, 2}, 1.0};
       }},
      {"approach's angle = ",
       [](GraspQuery& q) {
         q.approach = Cone{{0, 0, 1}, 0.0};
       }},
      {"region = ", [](GraspQuery& q) { q.region = Region{}; }},
      {"region = ",
       [](GraspQuery& q) {
         q.region = Region{Eigen::Isometry3d::Identity(),
                           {Eigen::Vector3d(0, nan, 0), Eigen::Vector3d(1, 1, 1)}};
       }},
      {"reach's base = ",
       [](GraspQuery& q) {
         q.reach = Reach{{0, 0, nan}, 0.0, 1.0};
       }},
      {"reach's least distance = ",
       [](GraspQuery& q) {
         q.reach = Reach{{0, 0, 0}, nan, 1.0};
       }},
      {"reach's greatest distance = ",
       [](GraspQuery& q) {
         q.reach = Reach{{0, 0, 0}, 2.0, 1.0};
       }},
      {"reach's greatest distance = ",
       [](GraspQuery& q) {
         q.reach = Reach{{0, 0, 0}, 0.0, 0.0};
       }},
      {"min_score = ", [](GraspQuery& q) { q.min_score = nan; }},
      {"min_score = ", [](GraspQuery& q) { q.min_score = 1.01; }},
      {"per_target = ", [](GraspQuery& q) { q.per_target = -1; }},
      {"max_grasps = ", [](GraspQuery& q) { q.max_grasps = 0; }},
      {"deadline_ms = ", [](GraspQuery& q) { q.deadline_ms = nan; }}};
  for (const auto& [field, spoil] : spoiled) {
    GraspQuery query;
    spoil(query);
    CHECK_THROWS_WITH(ready().plan(query), Catch::Matchers::StartsWith(field));
  }
}

TEST_CASE("each grasp says how it holds, and whence the hand comes", "[query]") {
  std::map<GraspKind, int> kinds;
  for (const Grasp& grasp : ready().plan().grasps) {
    ++kinds[grasp.kind];
    const Eigen::Vector3d way = grasp.X_CG.translation() - grasp.pregrasp().translation();
    CHECK((way - grasp.approach * grasp.X_CG.linear().col(2)).norm() < 1e-12);
    CHECK(grasp.pregrasp().linear().isApprox(grasp.X_CG.linear(), 0.0));
    // Held by the tips, a ball is not held across its middle.
    if (grasp.kind == GraspKind::kTip || grasp.target == 1) continue;
    const Detection& ball = scene().detections[grasp.target - 1];
    CHECK(grasp.width == Approx(2.0 * ball.dimensions[0].value).margin(1e-6));
  }
  CHECK(kinds[GraspKind::kAcross] > 0);
}

TEST_CASE("several threads may ask one scene", "[query]") {
  std::vector<GraspPlan> plans(4);
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k) {
      threads.emplace_back([&, k] {
        GraspQuery query;
        query.ids = {1 + k};
        plans[k] = ready().plan(query);
      });
    }
  }
  for (int k = 0; k < 4; ++k) {
    GraspQuery query;
    query.ids = {1 + k};
    test::check_same_grasps(plans[k], ready().plan(query));
  }
}

}  // namespace quadrille
