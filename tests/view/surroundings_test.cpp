#include <algorithm>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "support/catch.hpp"
#include "view/live/live_scene.hpp"

using namespace quadrille;

namespace {

constexpr std::int64_t kTaken = 1000000;

/// The pose of the camera when it took the cloud.
Eigen::Isometry3d taken_from() {
  return Eigen::Translation3d(0.0, 0.0, 2.0) *
         Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
}

view::Bytes kept(std::vector<std::byte> bytes) {
  return std::make_shared<const std::vector<std::byte>>(std::move(bytes));
}

bus::CloudMessage cloud_in(const std::string& frame) {
  bus::CloudMessage message;
  message.utime = kTaken;
  message.cloud.frame = frame;
  message.cloud.points = {{0.1f, 0.2f, 1.5f}};
  message.cloud.read = 1;
  return message;
}

/// The messages of a cloud in one frame with empty results in another.
view::LatestMessages messages_in(const std::string& cloud_frame, const std::string& result_frame) {
  view::LatestMessages messages;
  messages.clouds = {kept(bus::encode_cloud(cloud_in(cloud_frame), bus::CloudFormat::kDrake))};
  messages.quadrics = kept(bus::encode(bus::to_message(cloud_in(result_frame), DetectionResult{})));
  return messages;
}

/// Adds poses of a camera that moves past taken_from(), half a centimetre and more each.
void add_poses(view::LatestMessages& messages) {
  messages.camera.emplace();
  for (int i = -2; i <= 2; ++i) {
    Eigen::Isometry3d X_WK = taken_from();
    X_WK.translation().x() += 0.1 * i;
    messages.camera->add(bus::encode_pose({kTaken + 40000 * i, X_WK}));
  }
}

collision_shape_t shape_at(const Eigen::Vector3d& p, const std::string& kind,
                           const std::vector<double>& dimensions) {
  collision_shape_t shape{};
  shape.kind = kind;
  shape.pose = bus::to_message(Eigen::Isometry3d(Eigen::Translation3d(p)));
  shape.dimensions = dimensions;
  shape.num_dimensions = static_cast<std::int32_t>(dimensions.size());
  return shape;
}

robot_t robot_in(const std::string& frame) {
  robot_t robot{};
  robot.utime = kTaken;
  robot.frame = frame;
  robot.shapes = {shape_at({0.0, 0.0, 0.5}, "capsule", {0.1, 0.3})};
  robot.num_shapes = 1;
  return robot;
}

view::Bytes obstacles_in(const std::string& frame) {
  collision_shapes_t obstacles{};
  obstacles.frame = frame;
  obstacles.shapes = {shape_at({1.0, 0.0, 0.0}, "box", {0.1, 0.2, 0.3}),
                      shape_at({1.0, 0.0, 0.0}, "cube", {0.1})};
  obstacles.num_shapes = 2;
  return kept(bus::encode(obstacles));
}

view::Scene scene_made_of(const view::LatestMessages& messages, bool cloud_in_world = false) {
  const auto no_gripper = [](const std::string&) { return std::optional<Gripper>(); };
  return view::live_scene(messages, no_gripper, {}, cloud_in_world);
}

bool warns_of(const view::Scene& scene, const std::string& text) {
  return std::any_of(scene.warnings.begin(), scene.warnings.end(), [&](const std::string& warning) {
    return warning.find(text) != std::string::npos;
  });
}

nlohmann::json page_json_of(const view::Scene& scene) {
  const std::string pack = view::pack_scene(scene);
  std::uint32_t size = 0;
  std::memcpy(&size, pack.data() + 4, sizeof size);
  return nlohmann::json::parse(pack.substr(8, size));
}

}  // namespace

TEST_CASE("a cloud of a camera that moves is shown in the frame of the results", "[view][poses]") {
  view::LatestMessages messages = messages_in("depth", "world");
  add_poses(messages);
  const view::Scene scene = scene_made_of(messages);
  CHECK(scene.warnings.empty());
  CHECK(scene.cloud.frame == "world");
  CHECK(scene.utime == kTaken);
  REQUIRE(scene.cloud.points.size() == 1);
  CHECK(scene.cloud.points[0].isApprox(Eigen::Vector3f(0.1f, -0.2f, 0.5f), 1e-5f));
  CHECK(scene.cloud.viewpoint.isApprox(Eigen::Vector3d(0.0, 0.0, 2.0), 1e-6));
  REQUIRE(scene.X_CK);
  CHECK(scene.X_CK->isApprox(taken_from(), 1e-6));
  CHECK(scene.path.size() == 5);
}

TEST_CASE("a cloud in the frame of the results stays where it is", "[view][poses]") {
  view::LatestMessages messages = messages_in("depth", "depth");
  add_poses(messages);
  view::Scene scene = scene_made_of(messages);
  CHECK(scene.cloud.frame == "depth");
  REQUIRE(scene.cloud.points.size() == 1);
  CHECK(scene.cloud.points[0] == Eigen::Vector3f(0.1f, 0.2f, 1.5f));
  // The path is drawn about the camera, which is at the origin.
  CHECK(scene.X_CK->isApprox(Eigen::Isometry3d::Identity(), 1e-6));
  CHECK(scene.path.at(2).norm() == Approx(0.0).margin(1e-6));
  // In the fixed frame only the pose tells where the sensor was.
  scene = scene_made_of(messages, true);
  CHECK(scene.cloud.points.at(0) == Eigen::Vector3f(0.1f, 0.2f, 1.5f));
  CHECK(scene.cloud.viewpoint.isApprox(Eigen::Vector3d(0.0, 0.0, 2.0), 1e-6));
}

TEST_CASE("a cloud that cannot be placed is left out, with a warning that names the remedy",
          "[view][poses]") {
  view::LatestMessages messages = messages_in("depth", "world");
  view::Scene scene = scene_made_of(messages);
  CHECK(scene.cloud.points.empty());
  CHECK(warns_of(scene, "it is in frame 'depth', the quadrics in 'world'"));
  CHECK(warns_of(scene, "give view the --pose-channel of the processes"));
  messages.camera.emplace();
  scene = scene_made_of(messages);
  CHECK(scene.cloud.points.empty());
  CHECK(warns_of(scene, "no pose has come"));
  CHECK_FALSE(warns_of(scene, "give view"));
}

TEST_CASE("the page gets the robot, obstacles, the camera and its path", "[view][pack]") {
  view::LatestMessages messages = messages_in("depth", "world");
  add_poses(messages);
  CHECK(!messages.robot.add(bus::encode(robot_in("camera"))));
  messages.obstacles = obstacles_in("world");
  const view::Scene scene = scene_made_of(messages);
  CHECK(scene.warnings.empty());
  const auto json = page_json_of(scene);
  REQUIRE(json["robot"].size() == 1);
  CHECK(json["robot"][0]["kind"] == "capsule");
  CHECK(json["robot"][0]["dimensions"] == std::vector<double>{0.1, 0.3});
  CHECK(json["robot"][0]["pose"]["position"][2].get<double>() == Approx(1.5));
  // A shape that makes no solid is left out.
  REQUIRE(json["obstacles"].size() == 1);
  CHECK(json["obstacles"][0]["pose"]["position"][0] == 1.0);
  CHECK(json["camera"]["pose"]["position"][2].get<double>() == Approx(2.0));
  CHECK(json["camera"]["path"]["count"] == 15);
}

TEST_CASE("without poses a page has no camera, and shapes of other frames are left out",
          "[view][pack]") {
  view::LatestMessages messages = messages_in("depth", "depth");
  CHECK(!messages.robot.add(bus::encode(robot_in("depth"))));
  messages.obstacles = obstacles_in("world");
  const view::Scene scene = scene_made_of(messages);
  CHECK(warns_of(scene, "the obstacles are not shown: they are in frame 'world'"));
  CHECK(warns_of(scene, "give view the --pose-channel of the processes"));
  CHECK_FALSE(warns_of(scene, "robot"));
  const auto json = page_json_of(scene);
  CHECK(json["robot"].size() == 1);
  CHECK(json["obstacles"].empty());
  CHECK(json["camera"]["pose"].is_null());
  CHECK(json["camera"]["path"]["count"] == 0);
}

TEST_CASE("the page gets the views that the planner proposes", "[view][pack]") {
  view::LatestMessages messages = messages_in("depth", "world");
  grasps_t grasps{};
  grasps.utime = kTaken;
  grasps.frame = "world";
  grasps.looks.resize(1);
  grasps.num_looks = 1;
  grasps.looks[0].pose = bus::to_message(taken_from());
  grasps.looks[0].bodies = {3, 5};
  grasps.looks[0].num_bodies = 2;
  grasps.looks[0].gain = 0.75;
  messages.grasps = kept(bus::encode(grasps));
  const auto json = page_json_of(scene_made_of(messages));
  REQUIRE(json["looks"].size() == 1);
  CHECK(json["looks"][0]["bodies"] == std::vector<int>{3, 5});
  CHECK(json["looks"][0]["gain"] == 0.75);
  CHECK(json["looks"][0]["pose"]["position"][2] == 2.0);
}

TEST_CASE("damaged messages about the surroundings are left out", "[view][live][hostile]") {
  view::LatestMessages messages = messages_in("depth", "depth");
  const std::vector<std::byte> noise(300, std::byte{0xff});
  messages.camera.emplace();
  messages.camera->add(noise);
  CHECK(messages.robot.add(noise));
  messages.obstacles = kept(noise);
  const view::Scene scene = scene_made_of(messages);
  CHECK(scene.cloud.points.size() == 1);
  CHECK(scene.robot.empty());
  CHECK(scene.obstacles.empty());
  CHECK(scene.path.empty());
}

TEST_CASE("all channels on which messages come can get a prefix", "[view][live]") {
  view::LiveChannels channels;
  channels.poses = "POSE";
  view::LiveChannels::visit_inputs(channels, [](std::string& name) { name = "R2/" + name; });
  view::MessageKeeper keeper(channels);
  keeper.watch();
  const std::vector<std::byte> bytes(10);
  for (const char* name : {"R2/POINT_CLOUD", "R2/QUADRICS", "R2/BOXES", "R2/BODIES",
                           "R2/BODY_TRACKS", "R2/GRASPS", "R2/OCCUPANCY", "R2/OBSTACLES",
                           "R2/QUADRILLE_DETECTOR_STATUS", "R2/QUADRILLE_PLANNER_STATUS"}) {
    keeper.take(name, bytes);
  }
  keeper.take("R2/ROBOT", bus::encode(robot_in("camera")));
  keeper.take("R2/POSE", bus::encode_pose({kTaken, taken_from()}));
  const view::LatestMessages latest = keeper.latest();
  CHECK(latest.clouds.size() == 1);
  for (const view::Bytes& got :
       {latest.quadrics, latest.boxes, latest.bodies, latest.grasps, latest.occupancy,
        latest.obstacles, latest.detector_status, latest.planner_status}) {
    CHECK(got);
  }
  CHECK(latest.robot.at(kTaken));
  REQUIRE(latest.camera);
  CHECK(latest.camera->at(kTaken));
}

TEST_CASE("poses alone make no new scene", "[view][live]") {
  view::LiveChannels channels;
  channels.poses = "POSE";
  view::MessageKeeper keeper(channels);
  keeper.watch();
  keeper.take("POSE", bus::encode_pose({kTaken, taken_from()}));
  CHECK_FALSE(keeper.wait(std::chrono::milliseconds(1)));
  keeper.take("OBSTACLES", *obstacles_in("world"));
  CHECK(keeper.wait(std::chrono::milliseconds(1)));
}
