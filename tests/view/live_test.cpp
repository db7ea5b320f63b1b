#include <octomap/OcTree.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/json/json.hpp"
#include "io/planner/gripper_file.hpp"
#include "io/planner/octree_file.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/occupancy_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "support/catch.hpp"
#include "view/live/live_scene.hpp"

using namespace quadrille;

namespace {

view::Bytes shared(std::vector<std::byte> bytes) {
  return std::make_shared<const std::vector<std::byte>>(std::move(bytes));
}

bus::CloudMessage cloud_at(std::int64_t utime, float x = 0.0f) {
  bus::CloudMessage message;
  message.utime = utime;
  message.cloud.frame = "camera";
  message.cloud.points = {{x, 0, 1}, {x, 0.1f, 1}, {x, 0, 1.1f}};
  message.cloud.read = 3;
  return message;
}

view::Bytes cloud_bytes(std::int64_t utime, float x) {
  return shared(bus::encode_cloud(cloud_at(utime, x), bus::CloudFormat::kDrake));
}

view::Bytes quadrics_bytes(std::int64_t utime, int id) {
  Detection ball;
  ball.id = id;
  ball.track = 4;
  ball.type = QuadricType::kSphere;
  Vector10d q;
  q << 1, 1, 1, 0, 0, 0, 0, 0, -1, 0.99;
  ball.Q_C = Quadric(q).normalized();
  ball.score = 0.9;
  ball.X_CQ = Eigen::Translation3d(0, 0, 1);
  ball.dimensions = {{"radius", 0.1, 0.001}};
  ball.extent_Q =
      Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-0.1), Eigen::Vector3d::Constant(0.1));
  DetectionResult result;
  result.detections = {ball};
  return shared(bus::encode(bus::to_message(cloud_at(utime), result)));
}

view::Bytes boxes_bytes(std::int64_t utime, int id) {
  Box box;
  box.id = id;
  box.size.setConstant(0.1);
  box.inner_B = box.outer_B = {Eigen::Vector3d::Constant(-0.05), Eigen::Vector3d::Constant(0.05)};
  return shared(bus::encode(bus::to_message(cloud_at(utime), std::vector<Box>{box})));
}

/// The bodies of a cloud: a lump, and a mug of which the surface 3 is a part.
view::Bytes bodies_bytes(std::int64_t utime, int id) {
  std::vector<SceneBody> bodies(2);
  bodies[0].id = id;
  bodies[0].kind = BodyKind::kLump;
  bodies[0].size = {0.05, 0.04, 0.03};
  bodies[0].points = 120;
  bodies[1].id = id + 1;
  bodies[1].kind = BodyKind::kRevolution;
  bodies[1].parts = {3};
  bodies[1].wall = BodyWall{0.0045, 0.0015};
  return shared(bus::encode(bus::to_message(cloud_at(utime), bodies)));
}

/// A map of one occupied voxel.
view::Bytes occupancy_bytes(std::int64_t utime) {
  octomap::OcTree tree(0.01);
  tree.updateNode(octomap::point3d(0.0f, 0.0f, 1.0f), true);
  const std::string data = io::octree_bytes(tree);
  occupancy_t m{};
  m.utime = utime;
  m.frame = "camera";
  m.resolution = 0.01;
  m.data.assign(data.begin(), data.end());
  m.data_size = static_cast<std::int32_t>(m.data.size());
  return shared(bus::encode(m));
}

view::Bytes grasps_bytes(std::int64_t utime, int target, int track, std::int64_t request = 0,
                         const std::string& frame = "camera") {
  grasps_t m{};
  m.request_id = request;
  m.utime = utime;
  m.frame = frame;
  m.gripper = "franka";
  m.unknown = "target-shadow";
  m.grasps.resize(1);
  m.grasps[0].target = target;
  m.grasps[0].track = track;
  m.grasps[0].pose.quaternion[0] = 1.0;
  m.num_grasps = 1;
  m.rejected = {{"width", 5}};
  m.num_rejected = 1;
  m.remedies.resize(1);
  m.remedies[0].target = target;
  m.remedies[0].change = "--gripper wsg50";
  m.num_remedies = 1;
  return shared(bus::encode(m));
}

std::optional<Gripper> find_gripper(const std::string& name) { return io::load_gripper(name); }

}  // namespace

TEST_CASE("quadrics are shown with their own cloud, not with the newest", "[view][live]") {
  view::LatestMessages messages;
  messages.clouds = {cloud_bytes(100, 0.1f), cloud_bytes(200, 0.2f), cloud_bytes(300, 0.3f)};
  messages.quadrics = quadrics_bytes(200, 1);
  const view::Scene scene = view::live_scene(messages, find_gripper);
  CHECK(scene.utime == 200);
  REQUIRE(scene.cloud.points.size() == 3);
  CHECK(scene.cloud.points[0].x() == 0.2f);
  CHECK(scene.detections.size() == 1);
  messages.quadrics = nullptr;
  CHECK(view::live_scene(messages, find_gripper).cloud.points[0].x() == 0.3f);
}

TEST_CASE("quadrics are shown with their own boxes and lumps", "[view][live]") {
  view::LatestMessages messages;
  messages.clouds = {cloud_bytes(100, 0.1f), cloud_bytes(200, 0.2f)};
  messages.quadrics = quadrics_bytes(100, 1);
  messages.boxes_before = boxes_bytes(100, 5);
  messages.boxes = boxes_bytes(200, 6);
  REQUIRE(view::live_scene(messages, find_gripper).boxes.size() == 1);
  CHECK(view::live_scene(messages, find_gripper).boxes[0].id == 5);
  messages.quadrics = quadrics_bytes(200, 2);
  CHECK(view::live_scene(messages, find_gripper).boxes.at(0).id == 6);
  CHECK(view::live_scene(messages, find_gripper).lumps.empty());
  messages.bodies_before = bodies_bytes(200, 7);
  messages.bodies = bodies_bytes(300, 8);
  const view::Scene scene = view::live_scene(messages, find_gripper);
  REQUIRE(scene.lumps.size() == 1);
  CHECK(scene.lumps[0].id == 7);
  messages.quadrics = quadrics_bytes(300, 3);
  CHECK(view::live_scene(messages, find_gripper).boxes.empty());
}

TEST_CASE("a body and its parts say how many views show them, and since when none does",
          "[view][live]") {
  SceneBody ball, lump;
  ball.id = 3;
  ball.parts = {3, 8};
  ball.views = 2;
  ball.unseen = 1.5;
  lump.id = 7;
  lump.kind = BodyKind::kLump;
  view::LatestMessages messages;
  messages.clouds = {cloud_bytes(200, 0.2f)};
  messages.quadrics = quadrics_bytes(200, 3);
  messages.boxes = boxes_bytes(200, 8);
  const auto objects = [&] {
    const std::string pack = view::pack_scene(view::live_scene(messages, find_gripper));
    std::uint32_t size = 0;
    std::memcpy(&size, pack.data() + 4, sizeof size);
    return nlohmann::json::parse(pack.substr(8, size))["objects"];
  };
  CHECK_FALSE(objects().at(0).contains("views"));
  messages.bodies =
      shared(bus::encode(bus::to_message(cloud_at(200), std::vector<SceneBody>{ball, lump})));
  const auto shown = objects();
  REQUIRE(shown.size() == 3);
  for (const std::size_t n : {0, 1}) {
    CHECK(shown[n]["views"] == 2);
    CHECK(shown[n]["unseen"] == 1.5);
  }
  CHECK(shown[2]["views"] == 1);
  CHECK(shown[2]["unseen"] == 0.0);
}

TEST_CASE("grasps of an earlier cloud are shown on the surface of their track", "[view][live]") {
  view::LatestMessages messages;
  messages.clouds = {cloud_bytes(200, 0.2f)};
  messages.quadrics = quadrics_bytes(200, 3);
  messages.grasps = grasps_bytes(100, 1, 4);
  view::Scene scene = view::live_scene(messages, find_gripper);
  REQUIRE(scene.grasps.size() == 1);
  CHECK(scene.grasps[0].target == 3);
  CHECK(scene.gripper.has_value());
  CHECK(scene.unknown == UnknownPolicy::kTargetShadow);
  CHECK(scene.rejected.at("width") == 5);
  CHECK(scene.remedies.empty());
  messages.grasps = grasps_bytes(100, 3, 9);
  scene = view::live_scene(messages, find_gripper);
  CHECK(scene.grasps.at(0).target == 0);
}

TEST_CASE("a plan and a map of an earlier cloud say how old they are", "[view][live]") {
  const auto notes = [](const view::LatestMessages& messages) {
    return view::live_scene(messages, find_gripper).notes;
  };
  view::LatestMessages messages;
  messages.clouds = {cloud_bytes(2'400'000, 0.2f)};
  messages.quadrics = quadrics_bytes(2'400'000, 3);
  messages.grasps = grasps_bytes(2'000'000, 1, 4);
  messages.occupancy = occupancy_bytes(1'150'000);
  CHECK(notes(messages) ==
        std::vector<std::string>{"the grasps were planned on a cloud 0.40 s older",
                                 "occupied and unknown space is that of a cloud 1.25 s older"});
  // Also before the quadrics of the newest cloud have come, or if none ever come.
  messages.quadrics = nullptr;
  CHECK(notes(messages).size() == 2);
  messages.grasps = grasps_bytes(2'400'000, 1, 4);
  messages.occupancy = occupancy_bytes(2'400'000);
  CHECK(notes(messages).empty());
  // A log that is played again.
  messages.grasps = grasps_bytes(3'000'000, 1, 4);
  CHECK(notes(messages) == std::vector<std::string>{"the grasps were planned on another cloud"});
}

TEST_CASE("a page without a cloud or grasps says why", "[view][live]") {
  view::LatestMessages messages;
  messages.quadrics = quadrics_bytes(200, 3);
  const auto warnings = [&] {
    const auto all = view::live_scene(messages, find_gripper).warnings;
    return all.empty() ? std::string() : all.front();
  };
  CHECK(warnings().starts_with("no cloud has come yet"));
  messages.clouds = {cloud_bytes(100, 0.2f)};
  CHECK(warnings().starts_with("the cloud of these quadrics is not among the last that came"));
  messages.clouds = {cloud_bytes(200, 0.2f)};
  CHECK(warnings().empty());
  messages.grasps = grasps_bytes(200, 3, 4, 0, "world");
  CHECK(warnings() ==
        "the grasps are not shown: they are in frame 'world', the rest in 'camera'; give detector "
        "and planner the same --result-frame");
}

TEST_CASE("an answer to others replaces no plan of all objects, but is shown where there is none",
          "[view][live]") {
  view::MessageKeeper keeper({});
  const view::Bytes answer = grasps_bytes(100, 1, 4, 77), plan = grasps_bytes(100, 2, 4);
  keeper.take("GRASPS", *answer);
  REQUIRE(keeper.latest().grasps);
  CHECK(*keeper.latest().grasps == *answer);
  keeper.take("GRASPS", *plan);
  keeper.take("GRASPS", *answer);
  CHECK(*keeper.latest().grasps == *plan);
}

TEST_CASE("damaged messages are left out", "[view][live][hostile]") {
  view::LatestMessages messages;
  const view::Bytes noise = shared(std::vector<std::byte>(300, std::byte{0xff}));
  messages.clouds = {noise};
  messages.quadrics = messages.boxes_before = messages.boxes = messages.grasps = noise;
  messages.occupancy = messages.detector_status = messages.planner_status = noise;
  const view::Scene scene = view::live_scene(messages, find_gripper);
  CHECK(scene.detections.empty());
  CHECK(scene.cloud.points.empty());
  CHECK(view::live_status(messages).empty());
  CHECK(view::pack_scene(scene).starts_with("QVW1"));
}

TEST_CASE("the page tells how much both processes remember", "[view][live]") {
  detector_status_t detector{};
  planner_status_t planner{};
  view::LatestMessages messages;
  const auto has_memory = [&](const std::string& process) {
    messages.detector_status = shared(bus::encode(detector));
    messages.planner_status = shared(bus::encode(planner));
    const auto facts = view::live_status(messages)[process]["facts"];
    const auto views = io::Json::array({"views remembered", "5"});
    const auto shift = io::Json::array({"pose corrected by", "1.5 mm"});
    return std::count(facts.begin(), facts.end(), views) == 1 &&
           std::count(facts.begin(), facts.end(), shift) == 1;
  };
  CHECK_FALSE(has_memory("detector"));
  detector.remembered_views = planner.remembered_views = 5;
  detector.pose_correction = planner.pose_correction = 0.0015;
  CHECK(has_memory("detector"));
  CHECK(has_memory("planner"));
}

TEST_CASE("clouds are kept only while somebody looks, and never more than a few", "[view][live]") {
  view::MessageKeeper keeper{view::LiveChannels{}};
  const std::vector<std::byte> cloud(std::size_t{20} << 20);
  keeper.take("POINT_CLOUD", cloud);
  CHECK(keeper.latest().clouds.empty());
  keeper.watch();
  for (int i = 0; i < 20; ++i) keeper.take("POINT_CLOUD", cloud);
  CHECK(keeper.latest().clouds.size() == view::MessageKeeper::kMaxCloudBytes / cloud.size());
  for (int i = 0; i < 20; ++i) keeper.take("POINT_CLOUD", std::vector<std::byte>(10));
  CHECK(keeper.latest().clouds.size() == view::MessageKeeper::kMaxClouds);
  keeper.take("OTHER", cloud);
  CHECK(!keeper.latest().quadrics);
}

TEST_CASE("a packed scene holds what it was made of", "[view][pack]") {
  view::LatestMessages messages;
  messages.clouds = {cloud_bytes(200, 0.2f)};
  messages.quadrics = quadrics_bytes(200, 3);
  messages.grasps = grasps_bytes(200, 3, 4);
  messages.bodies = bodies_bytes(200, 7);
  const std::string pack = view::pack_scene(view::live_scene(messages, find_gripper));
  std::uint32_t size = 0;
  std::memcpy(&size, pack.data() + 4, sizeof size);
  const auto json = nlohmann::json::parse(pack.substr(8, size));
  const std::string arrays = pack.substr(8 + size);
  REQUIRE(json["points"]["count"] == 9);
  std::uint16_t steps[9];
  std::memcpy(steps, arrays.data() + json["points"]["at"].get<std::size_t>(), sizeof steps);
  const double y =
      json["points"]["min"][1].get<double>() + steps[4] * json["points"]["step"][1].get<double>();
  CHECK(y == Approx(0.1).margin(1e-5));
  REQUIRE(json["objects"].size() == 2);
  CHECK(json["objects"][1]["type"] == "lump");
  CHECK(json["objects"][1]["lines"][0] == "seen 50 x 40 x 30 mm");
  CHECK(json["objects"][1]["size"][2] == 0.03);
  CHECK(json["objects"][0]["lines"][0] == "radius 100.0 ± 1.0 mm");
  CHECK(json["objects"][0]["lines"].back() == "wall 4.5 ± 1.5 mm");
  CHECK(json["grasps"][0]["target"] == 3);
  CHECK(json["rejected"][0]["reason"] == "width");
  CHECK(json["remedies"][0]["target"] == 3);
  CHECK(json["remedies"][0]["change"] == "--gripper wsg50");
  CHECK(json["rejected"][0]["help"].get<std::string>().find("--gripper") != std::string::npos);
}
