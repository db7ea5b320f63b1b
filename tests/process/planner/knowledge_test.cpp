#include "process/planner/knowledge.hpp"

#include <octomap/OcTree.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "io/planner/octree_file.hpp"
#include "process/scene_messages.hpp"
#include "quadrille/grasping/shape.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"

namespace quadrille {
namespace {

using test::ball_message;

/// A cloud in the frame "lidar", with results in the fixed frame.
CloudAndQuadrics placed_pair(std::int64_t utime = 1000) {
  CloudAndQuadrics pair;
  auto cloud = std::make_shared<bus::CloudMessage>();
  cloud->utime = utime;
  cloud->cloud.frame = "lidar";
  pair.cloud = cloud;
  pair.placement.X_CK = Eigen::Translation3d(0.3, 0.1, -0.2) *
                        Eigen::AngleAxisd(0.4, Eigen::Vector3d(2, 1, 2).normalized());
  pair.placement.X_WK = Eigen::Translation3d(1.0, -2.0, 0.5) *
                        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -2).normalized());
  pair.placement.X_RK = *pair.placement.X_WK;
  pair.placement.frame = "world";
  return pair;
}

/// Each frame that a message may name, with the pose of the camera in it.
std::vector<std::pair<std::string, Eigen::Isometry3d>> named_frames(const Placement& placement) {
  return {{"world", *placement.X_WK},
          {"camera", Eigen::Isometry3d::Identity()},
          {"lidar", placement.X_CK},
          {"", placement.X_RK}};
}

/// Knowledge that is told by messages alone.
struct Told {
  explicit Told(PlannerSettings given = {}) : settings(std::move(given)), knowledge(settings) {}

  bool take(const std::string& channel, const std::vector<std::byte>& bytes) {
    return knowledge.receive(channel, bytes, &refusals);
  }

  PlannerSettings settings;
  Refusals refusals;
  Knowledge knowledge;
};

std::vector<std::byte> map_bytes(const std::string& frame, const octomap::OcTree& tree) {
  occupancy_t m{};
  m.frame = frame;
  m.resolution = tree.getResolution();
  const std::string data = io::octree_bytes(tree);
  m.data.assign(data.begin(), data.end());
  m.data_size = static_cast<int>(data.size());
  return bus::encode(m);
}

}  // namespace

TEST_CASE("nothing is known before anything is told", "[process][knowledge]") {
  const Told told;
  const Known known = told.knowledge.about(placed_pair());
  CHECK(known.obstacles.empty());
  CHECK(known.attached.empty());
  CHECK(known.surroundings.robot.shapes.empty());
  CHECK_FALSE(known.surroundings.support);
  CHECK_FALSE(known.surroundings.map.tree);
}

TEST_CASE("what messages tell comes from the frame that they name", "[process][knowledge]") {
  const CloudAndQuadrics pair = placed_pair();
  const Eigen::Vector3d p_K(0.2, -0.3, 0.8);
  octomap::OcTree tree(0.02);
  tree.updateNode(octomap::point3d(0.11f, 0.13f, 0.17f), true);
  for (const auto& [frame, X_FK] : named_frames(pair.placement)) {
    CAPTURE(frame);
    Told told;
    const Eigen::Vector3d p_F = X_FK * p_K;
    CHECK(told.take("OBSTACLES", test::shapes_bytes(frame, {ball_message(p_F, 0.05)})));
    CHECK(told.take("ROBOT", test::robot_bytes(0, frame, {ball_message(p_F, 0.04)}, 0.01,
                                               {ball_message({0, 0, -0.1}, 0.03)})));
    const Eigen::Vector3d n_K(0.0, -0.6, -0.8);
    const Eigen::Vector3d n_F = X_FK.linear() * n_K;
    CHECK(told.take("SUPPORT", test::support_bytes(frame, n_F, n_F.dot(p_F))));
    CHECK(told.take("MAP", map_bytes(frame, tree)));
    CHECK(told.refusals.counts().total() == 0);

    const Known known = told.knowledge.about(pair);
    REQUIRE(known.obstacles.size() == 1);
    CHECK((known.obstacles[0].X_CS.translation() - p_K).norm() < 1e-12);
    CHECK(known.obstacles[0].geometry);
    REQUIRE(known.surroundings.robot.shapes.size() == 1);
    CHECK((known.surroundings.robot.shapes[0].X_CS.translation() - p_K).norm() < 1e-12);
    REQUIRE(known.surroundings.support);
    CHECK((known.surroundings.support->n_C - n_K).norm() < 1e-12);
    CHECK(known.surroundings.support->offset == Approx(n_K.dot(p_K)));
    REQUIRE(known.surroundings.map.tree);
    const Eigen::Vector3d p_M(0.11, 0.13, 0.17);
    CHECK((known.surroundings.map.X_CM * p_M - X_FK.inverse() * p_M).norm() < 1e-12);
    CHECK(known.surroundings.map.tree->search(0.11, 0.13, 0.17) != nullptr);
    // What is attached is in the hand's frame, whatever frame the message names.
    REQUIRE(known.attached.size() == 1);
    CHECK(known.attached[0].X_CS.translation() == Eigen::Vector3d(0, 0, -0.1));
    CHECK(known.attached[0].geometry);
  }
}

TEST_CASE("of each kind the newest message counts", "[process][knowledge]") {
  Told told;
  const CloudAndQuadrics pair = placed_pair();
  octomap::OcTree first(0.02), second(0.05);
  first.updateNode(octomap::point3d(0.1f, 0.1f, 0.1f), true);
  second.updateNode(octomap::point3d(0.1f, 0.1f, 0.1f), false);
  told.take("OBSTACLES", test::shapes_bytes("camera", {ball_message({0, 0, 1}, 0.1),
                                                       ball_message({0, 0, 2}, 0.1)}));
  told.take("SUPPORT", test::support_bytes("camera", {0, 0, 1}, 0.1));
  told.take("MAP", map_bytes("camera", first));
  REQUIRE(told.knowledge.about(pair).obstacles.size() == 2);
  told.take("OBSTACLES", test::shapes_bytes("camera", {ball_message({0, 0, 3}, 0.1)}));
  told.take("SUPPORT", test::support_bytes("camera", {0, 1, 0}, 0.2));
  told.take("MAP", map_bytes("camera", second));
  Known known = told.knowledge.about(pair);
  REQUIRE(known.obstacles.size() == 1);
  CHECK(known.obstacles[0].X_CS.translation().z() == 3.0);
  CHECK(known.surroundings.support->offset == 0.2);
  CHECK(known.surroundings.map.tree->getResolution() == Approx(0.05));
  // A message without a map takes the one before away, in whatever frame.
  occupancy_t none{};
  none.frame = "moon";
  none.resolution = 0.05;
  told.take("MAP", bus::encode(none));
  CHECK_FALSE(told.knowledge.about(pair).surroundings.map.tree);
  // An empty list takes all obstacles away.
  told.take("OBSTACLES", test::shapes_bytes("camera", {}));
  CHECK(told.knowledge.about(pair).obstacles.empty());
  // A plane without a normal withdraws the one before.
  told.take("SUPPORT", test::support_bytes("camera", {0, 0, 0}, 0.0));
  CHECK_FALSE(told.knowledge.about(pair).surroundings.support);
}

TEST_CASE("messages of the bus add to the command line, or take its place",
          "[process][knowledge]") {
  PlannerSettings settings;
  settings.pose_channel = "POSE";
  SolidShape box;
  box.kind = "box";
  box.dimensions = {0.1, 0.2, 0.3};
  box.X_CS.translation() = Eigen::Vector3d(0.5, 0.6, 0.7);
  settings.obstacles = {with_geometry(box)};
  settings.attached = {with_geometry(box)};
  settings.known.robot.shapes = {box};
  settings.known.support = KnownSupport{Eigen::Vector3d::UnitZ(), 0.25};
  const CloudAndQuadrics pair = placed_pair();
  const Eigen::Isometry3d X_KW = pair.placement.X_WK->inverse();
  Told told(settings);
  // What the command line says is in the fixed frame, if there is one.
  Known known = told.knowledge.about(pair);
  REQUIRE(known.obstacles.size() == 1);
  CHECK((known.obstacles[0].X_CS.matrix() - (X_KW * box.X_CS).matrix()).norm() < 1e-12);
  REQUIRE(known.surroundings.robot.shapes.size() == 1);
  CHECK((known.surroundings.robot.shapes[0].X_CS.matrix() - (X_KW * box.X_CS).matrix()).norm() <
        1e-12);
  REQUIRE(known.surroundings.support);
  CHECK(known.surroundings.support->n_C.dot(X_KW * Eigen::Vector3d(3, 4, 0.25)) ==
        Approx(known.surroundings.support->offset));
  CHECK(known.attached.at(0).X_CS.matrix() == box.X_CS.matrix());

  told.take("OBSTACLES", test::shapes_bytes("camera", {ball_message({0, 0, 3}, 0.1)}));
  told.take("SUPPORT", test::support_bytes("camera", {0, 1, 0}, 0.125));
  told.take("ROBOT", test::robot_bytes(0, "camera", {ball_message({0, 0, 3}, 0.1)}, 0.005,
                                       {ball_message({0, 0, 0}, 0.1)}));
  known = told.knowledge.about(pair);
  CHECK(known.obstacles.size() == 2);
  CHECK(known.attached.size() == 2);
  CHECK(known.surroundings.robot.shapes.size() == 2);
  CHECK(known.surroundings.support->n_C == Eigen::Vector3d(0, 1, 0));
  told.take("SUPPORT", test::support_bytes("camera", {0, 0, 0}, 0.0));
  CHECK_FALSE(told.knowledge.about(pair).surroundings.support);

  // Without a fixed frame it is in the camera's.
  settings.pose_channel.clear();
  const Told at_rest(settings);
  CHECK(at_rest.knowledge.about(pair).obstacles[0].X_CS.isApprox(box.X_CS));
}

TEST_CASE("bad messages are counted, and what was known before stays",
          "[process][knowledge][hostile]") {
  Told told;
  const CloudAndQuadrics pair = placed_pair();
  told.take("OBSTACLES", test::shapes_bytes("camera", {ball_message({0, 0, 1}, 0.1)}));
  told.take("SUPPORT", test::support_bytes("camera", {0, 0, 1}, 0.1));
  REQUIRE(told.refusals.counts().total() == 0);
  std::int64_t refused = 0;
  const auto take_bad = [&](const std::string& channel, const std::vector<std::byte>& bytes) {
    CAPTURE(channel);
    CHECK(told.take(channel, bytes));
    CHECK(told.refusals.counts().total() == ++refused);
  };
  take_bad("OBSTACLES", test::shapes_bytes("camera", {ball_message({0, 0, 1}, 0.1),
                                                      ball_message({0, 0, 1}, 0.0)}));
  collision_shape_t torus = ball_message({0, 0, 1}, 0.1);
  torus.kind = "torus";
  take_bad("OBSTACLES", test::shapes_bytes("camera", {torus}));
  take_bad("SUPPORT", test::support_bytes("camera", {0, 0, 2}, 0.1));
  take_bad("ROBOT", test::robot_bytes(0, "camera", {torus}));
  occupancy_t map{};
  map.resolution = 0.01;
  map.data = {1, 2, 3};
  map.data_size = 3;
  take_bad("MAP", bus::encode(map));
  CHECK(told.refusals.counts().of(bus::RejectReason::kBadValue) == refused);
  for (const char* channel : {"OBSTACLES", "SUPPORT", "ROBOT", "MAP"}) take_bad(channel, {});
  const Known known = told.knowledge.about(pair);
  CHECK(known.obstacles.size() == 1);
  CHECK(known.surroundings.support->offset == 0.1);
  CHECK_FALSE(known.surroundings.map.tree);
  CHECK(known.surroundings.robot.shapes.empty());
}

TEST_CASE("only the channels of knowledge are taken", "[process][knowledge]") {
  PlannerSettings settings;
  settings.obstacles_channel = "FENCES";
  Told told(settings);
  const std::vector<std::byte> bytes = test::shapes_bytes("", {ball_message({0, 0, 1}, 0.1)});
  CHECK_FALSE(told.take("OBSTACLES", bytes));
  CHECK_FALSE(told.take("POINT_CLOUD", bytes));
  CHECK(told.knowledge.about(placed_pair()).obstacles.empty());
  CHECK(told.take("FENCES", bytes));
  CHECK(told.knowledge.about(placed_pair()).obstacles.size() == 1);
}

TEST_CASE("what is in a frame that nobody knows is told by its name", "[process][knowledge]") {
  const CloudAndQuadrics pair = placed_pair();
  octomap::OcTree tree(0.02);
  tree.updateNode(octomap::point3d(0.1f, 0.1f, 0.1f), true);
  const std::vector<std::pair<std::string, std::vector<std::byte>>> messages = {
      {"OBSTACLES", test::shapes_bytes("moon", {ball_message({0, 0, 1}, 0.1)})},
      {"SUPPORT", test::support_bytes("moon", {0, 0, 1}, 0.1)},
      {"ROBOT", test::robot_bytes(0, "moon", {ball_message({0, 0, 1}, 0.1)})},
      {"MAP", map_bytes("moon", tree)}};
  for (const auto& [channel, bytes] : messages) {
    CAPTURE(channel);
    Told told;
    told.take(channel, bytes);
    const std::string why = test::error_of([&] { told.knowledge.about(pair); });
    CHECK(why.find("moon") != std::string::npos);
    CHECK(why.find("lidar") != std::string::npos);
    CHECK_THROWS_AS(told.knowledge.about(pair), std::invalid_argument);
  }
  // The fixed frame is not known without a pose.
  Told told;
  told.take("SUPPORT", test::support_bytes("world", {0, 0, 1}, 0.1));
  CloudAndQuadrics poseless = placed_pair();
  poseless.placement = {};
  CHECK(test::error_of([&] { told.knowledge.about(poseless); }).find("pose") != std::string::npos);
}

}  // namespace quadrille
