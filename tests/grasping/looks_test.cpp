// Views that are proposed for bodies without a sure grasp, on clouds rendered from where they say.
#include "quadrille/grasping/looks.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A slim can in front of a tall box on a table; the camera sees them from the front.
struct CanBeforeBox {
  Eigen::Isometry3d X_CW = world_seen_from({0.0, -0.55, 0.3});
  Eigen::Isometry3d X_CCan = X_CW * translation(0.0, 0.02, 0.06);
  std::vector<Patch> patches = [this] {
    std::vector<Patch> all = {rectangle(X_CW, 1.2, 0.9)};
    for (const Patch& p : can(X_CCan, 0.025, 0.12)) all.push_back(p);
    for (const Patch& p : box(X_CW * translation(0.0, 0.15, 0.1), {0.3, 0.06, 0.2})) {
      all.push_back(p);
    }
    return all;
  }();

  /// Renders the scene for a camera with this pose. The cloud is in frame C.
  PointCloud seen_from(const Eigen::Isometry3d& X_CK) const {
    std::vector<Patch> moved_patches = patches;
    for (Patch& p : moved_patches) p.X_CB = X_CK.inverse() * p.X_CB;
    Camera camera;
    camera.noise = 0.0005;
    return moved(render(moved_patches, camera), X_CK);
  }
};

struct Planned {
  std::vector<PointCloud> views;
  PlanOptions options;
  DetectionResult found = detect_views(views);
  GraspPlan plan = plan_grasps(views.front(), found.detections, franka_hand(), options,
                               {{views.begin() + 1, views.end()}}, {}, found.boxes, found.bodies);

  std::vector<Look> looks(int max = 3) const {
    return propose_looks(plan, found.bodies, found.detections, franka_hand(), options,
                         viewpoints_of(views.front(), {{views.begin() + 1, views.end()}}), max);
  }
  /// Takes all grasps away, as if nothing but this had refused them.
  void refuse_all(Refusal why) {
    plan.grasps.clear();
    for (TargetOutcome& outcome : plan.targets) {
      outcome.grasps = 0;
      outcome.refusals = {{why, 3}};
    }
  }
};

PlanOptions cautious() {
  PlanOptions options;
  options.unknown = UnknownPolicy::kObstacle;
  options.clear_above = false;
  return options;
}

/// The body whose middle is nearest to the can's.
const SceneBody& can_of(const Planned& planned, const CanBeforeBox& scene) {
  REQUIRE_FALSE(planned.found.bodies.empty());
  return *std::min_element(planned.found.bodies.begin(), planned.found.bodies.end(),
                           [&](const SceneBody& a, const SceneBody& b) {
                             const auto off = [&](const SceneBody& body) {
                               return (body.X_CB.translation() - scene.X_CCan.translation()).norm();
                             };
                             return off(a) < off(b);
                           });
}

std::size_t unknown_about(const Planned& planned, const Eigen::Vector3d& p_C) {
  const OccupancyGrid& space = *planned.plan.space;
  std::size_t count = 0;
  for (int k = 0; k < space.size().z(); ++k) {
    for (int j = 0; j < space.size().y(); ++j) {
      for (int i = 0; i < space.size().x(); ++i) {
        const bool near = (space.centre(i, j, k) - p_C).norm() < 0.08;
        count += near && space.at(i, j, k) == Voxel::kUnknown;
      }
    }
  }
  return count;
}

}  // namespace

TEST_CASE("a proposed view shows more of what is unknown than the first one", "[looks]") {
  const CanBeforeBox scene;
  const PointCloud first = scene.seen_from(Eigen::Isometry3d::Identity());
  const PlanOptions options = cautious();
  Planned one{{first}, options};
  one.refuse_all(Refusal::kUnknown);
  const std::vector<Look> looks = one.looks();
  REQUIRE_FALSE(looks.empty());
  const SceneBody& body = can_of(one, scene);
  const auto helps = [&](const Look& look) {
    return std::find(look.bodies.begin(), look.bodies.end(), body.id) != look.bodies.end();
  };
  const auto look = std::find_if(looks.begin(), looks.end(), helps);
  REQUIRE(look != looks.end());
  CHECK(look->gain > static_cast<double>(look->bodies.size()) / 3.0);
  CHECK(look->gain < static_cast<double>(look->bodies.size()));
  // The camera stands above the table, looks at things from there, and is upright.
  const Eigen::Vector3d eye_W = scene.X_CW.inverse() * look->X_CK.translation();
  CHECK(eye_W.z() > 0.05);
  const Eigen::Matrix3d R = look->X_CK.linear();
  CHECK(R.isUnitary(1e-9));
  CHECK(R.determinant() == Approx(1.0));
  CHECK(R.col(1).dot(scene.X_CW.linear().col(2)) < 1e-9);

  const Planned two{{first, scene.seen_from(look->X_CK)}, options};
  const Planned same{{first, scene.seen_from(Eigen::Isometry3d(translation(0.01, 0.0, 0.0)))},
                     options};
  const Eigen::Vector3d p_C = scene.X_CCan.translation();
  const std::size_t before = unknown_about(same, p_C);
  REQUIRE(before > 200);
  CHECK(unknown_about(two, p_C) < 0.75 * static_cast<double>(before));
}

TEST_CASE("no view is proposed from behind a wall", "[looks]") {
  const CanBeforeBox scene;
  Planned planned{{scene.seen_from(Eigen::Isometry3d::Identity())}, cautious()};
  planned.refuse_all(Refusal::kUnknown);
  const std::vector<Look> open = planned.looks(1);
  REQUIRE(open.size() == 1);
  // A wall between that place and the first viewpoint, seen from there.
  const Eigen::Vector3d eye_C = planned.views.front().viewpoint;
  const Eigen::Vector3d look_C = open.front().X_CK.translation();
  const Eigen::Vector3d n_C = (eye_C - look_C).normalized();
  Detection wall;
  wall.id = 1000;
  wall.type = QuadricType::kPlane;
  wall.X_CQ = Eigen::Translation3d(look_C + 0.02 * n_C) *
              Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), n_C);
  wall.extent_Q = {Eigen::Vector3d(-0.5, -0.5, 0.0), Eigen::Vector3d(0.5, 0.5, 0.0)};
  std::vector<Detection> detections = planned.found.detections;
  detections.push_back(wall);
  const std::vector<Look> looks = propose_looks(planned.plan, planned.found.bodies, detections,
                                                franka_hand(), planned.options, {eye_C}, 3);
  for (const Look& look : looks) {
    CHECK(n_C.dot(look.X_CK.translation() - wall.X_CQ.translation()) > 0.0);
  }
  wall.extent_Q = {Eigen::Vector3d(-0.05, -0.05, 0.0), Eigen::Vector3d(0.05, 0.05, 0.0)};
  detections.back() = wall;
  CHECK(propose_looks(planned.plan, planned.found.bodies, detections, franka_hand(),
                      planned.options, {eye_C}, 1)
            .front()
            .X_CK.isApprox(open.front().X_CK));
}

TEST_CASE("no view is proposed if nothing lacks a grasp", "[looks]") {
  const CanBeforeBox scene;
  PlanOptions options;
  options.unknown = UnknownPolicy::kFree;
  Planned planned{{scene.seen_from(Eigen::Isometry3d::Identity())}, options};
  const SceneBody body = can_of(planned, scene);
  std::erase_if(planned.found.bodies, [&](const SceneBody& other) { return other.id != body.id; });
  REQUIRE_FALSE(planned.plan.grasps.empty());
  for (Grasp& grasp : planned.plan.grasps) grasp.score = 0.95;
  CHECK(planned.looks().empty());
  // If the best grasp of the body is nearly sure, a view is proposed that may make it so.
  for (Grasp& grasp : planned.plan.grasps) grasp.score = 0.86;
  CHECK(planned.looks().size() == 1);
  // It seldom does so for a poor grasp.
  for (Grasp& grasp : planned.plan.grasps) grasp.score = 0.72;
  CHECK(planned.looks().empty());
}

TEST_CASE("what no view is likely to mend gets none", "[looks]") {
  const CanBeforeBox scene;
  Planned planned{{scene.seen_from(Eigen::Isometry3d::Identity())}, cautious()};
  for (const Refusal why :
       {Refusal::kWidth, Refusal::kSupport, Refusal::kScore, Refusal::kReach, Refusal::kCaller}) {
    planned.refuse_all(why);
    CHECK(planned.looks().empty());
  }
  planned.refuse_all(Refusal::kWidth);
  for (TargetOutcome& outcome : planned.plan.targets) outcome.refusals[Refusal::kUnknown] = 1;
  CHECK_FALSE(planned.looks().empty());
  CHECK(planned.looks(1).size() == 1);
  CHECK(planned.looks(0).empty());
  planned.plan.space = nullptr;
  CHECK(planned.looks().empty());
}

TEST_CASE("a body that is too wide even if it is smaller than it seems gets no view", "[looks]") {
  const CanBeforeBox scene;
  Planned planned{{scene.seen_from(Eigen::Isometry3d::Identity())}, cautious()};
  planned.refuse_all(Refusal::kCollision);
  const int id = can_of(planned, scene).id;
  std::erase_if(planned.found.bodies, [&](const SceneBody& body) { return body.id != id; });
  REQUIRE(planned.looks().size() == 1);
  SceneBody& can = planned.found.bodies.front();
  can.size = {0.1, 0.1, 0.12};
  can.std = {0.02, 0.02, 0.02};
  CHECK(planned.looks().size() == 1);
  can.std = {0.002, 0.002, 0.02};
  CHECK(planned.looks().empty());
}

TEST_CASE("a body without a grasp gets a view that helps it in one of three cases", "[looks]") {
  const CanBeforeBox scene;
  Planned planned{{scene.seen_from(Eigen::Isometry3d::Identity())}, cautious()};
  const int id = can_of(planned, scene).id;
  std::erase_if(planned.found.bodies, [&](const SceneBody& body) { return body.id != id; });
  for (const Refusal why : {Refusal::kNoShape, Refusal::kSeenFromInside, Refusal::kUnmeasured}) {
    planned.refuse_all(why);
    const std::vector<Look> looks = planned.looks();
    REQUIRE(looks.size() == 1);
    CHECK(looks.front().bodies == std::vector<int>{id});
    CHECK(looks.front().gain >= 1.0 / 3.0);
    CHECK(looks.front().gain < 0.5);
  }
}

TEST_CASE("a view names the bodies without a grasp before those that have one", "[looks]") {
  const CanBeforeBox scene;
  PlanOptions options;
  options.unknown = UnknownPolicy::kFree;
  Planned planned{{scene.seen_from(Eigen::Isometry3d::Identity())}, options};
  const int id = can_of(planned, scene).id;
  std::erase_if(planned.found.bodies, [&](const SceneBody& body) { return body.id != id; });
  REQUIRE_FALSE(planned.plan.grasps.empty());
  for (Grasp& grasp : planned.plan.grasps) grasp.score = 0.87;
  // Another body at the same place was only seen from inside.
  SceneBody other = planned.found.bodies.front();
  const int other_id = 1000;
  other.id = other_id;
  other.parts = {other_id};
  planned.found.bodies.push_back(other);
  planned.plan.targets.push_back({other_id, 0, {{Refusal::kSeenFromInside, 3}}});
  const std::vector<Look> looks = planned.looks(1);
  REQUIRE(looks.size() == 1);
  CHECK(looks.front().bodies == std::vector<int>{other_id, id});
  CHECK(looks.front().gain > 0.5);
}

TEST_CASE("a view from where the scene was seen already is worth little", "[looks]") {
  const CanBeforeBox scene;
  Planned planned{{scene.seen_from(Eigen::Isometry3d::Identity())}, cautious()};
  const int id = can_of(planned, scene).id;
  std::erase_if(planned.found.bodies, [&](const SceneBody& body) { return body.id != id; });
  planned.refuse_all(Refusal::kUnknown);
  const std::vector<Look> once = planned.looks(1);
  REQUIRE(once.size() == 1);
  const Eigen::Vector3d first_C = planned.views.front().viewpoint;
  const Eigen::Vector3d seen_C = once.front().X_CK.translation();
  const std::vector<Look> twice =
      propose_looks(planned.plan, planned.found.bodies, planned.found.detections, franka_hand(),
                    planned.options, {first_C, seen_C}, 1);
  REQUIRE(twice.size() == 1);
  const Eigen::Vector3d middle_C = planned.found.bodies.front().X_CB.translation();
  const Eigen::Vector3d now = twice.front().X_CK.translation() - middle_C;
  for (const Eigen::Vector3d& before_C : {first_C, seen_C}) {
    const Eigen::Vector3d before = before_C - middle_C;
    CHECK(now.dot(before) < std::cos(0.7) * now.norm() * before.norm());
  }
  CHECK_THROWS_AS(propose_looks(planned.plan, {}, {}, franka_hand(), {}, {}, 1),
                  std::invalid_argument);
}
