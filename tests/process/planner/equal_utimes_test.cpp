// Clouds whose sender does not tell the time, through both processes.
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <map>
#include <vector>

#include "process/detector/node.hpp"
#include "process/planner/node.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

using Message = std::vector<std::byte>;

bus::Publish keep_in(std::map<std::string, std::vector<Message>>& published) {
  return [&published](const std::string& channel, std::span<const std::byte> bytes) {
    published[channel].emplace_back(bytes.begin(), bytes.end());
  };
}

void give(Node& node, const std::string& channel, const Message& bytes) {
  if (const auto job = node.receive(channel, bytes)) node.work(*job);
}

/// A ball on a table, somewhere along it, at utime 0.
Message encode_ball(double y) {
  const Eigen::Isometry3d X_KT = test::world_seen_from({0.5, 0.1, 0.5});
  bus::CloudMessage message{0, 0, {}};
  message.cloud = test::render(
      {test::sphere(X_KT * test::translation(0, y, 0.03), 0.03), test::rectangle(X_KT, 2.0, 2.0)},
      {320, 240, 1.0 / 300.0});
  return bus::encode_cloud(message, bus::CloudFormat::kDrake);
}

PlannerSettings planner_settings() {
  PlannerSettings settings;
  settings.gripper = franka_hand();
  return settings;
}

/// What the planner says of a cloud that comes alone.
Message grasps_alone(const Message& cloud, const Message& quadrics) {
  std::map<std::string, std::vector<Message>> published;
  PlannerNode planner(planner_settings(), keep_in(published));
  give(planner, "POINT_CLOUD", cloud);
  give(planner, "QUADRICS", quadrics);
  return published.at("GRASPS").at(0);
}

}  // namespace

TEST_CASE("quadrics that come late are planned on with their own cloud, though all have one utime",
          "[process][pairing]") {
  const std::vector<Message> clouds = {encode_ball(-0.1), encode_ball(0.1)};
  std::map<std::string, std::vector<Message>> published;
  DetectorNode detector({}, keep_in(published));
  for (const Message& cloud : clouds) give(detector, "POINT_CLOUD", cloud);
  const std::vector<Message> quadrics = published.at("QUADRICS");
  PlannerNode planner(planner_settings(), keep_in(published));
  // The detector is always one cloud behind.
  give(planner, "POINT_CLOUD", clouds[0]);
  for (int n = 0; n < 4; ++n) {
    give(planner, "POINT_CLOUD", clouds[(n + 1) % 2]);
    give(planner, "QUADRICS", quadrics[n % 2]);
  }
  REQUIRE(published["GRASPS"].size() == 4);
  for (int n = 0; n < 4; ++n) {
    CHECK(published["GRASPS"][n] == grasps_alone(clouds[n % 2], quadrics[n % 2]));
  }
}

TEST_CASE("the status and the end of a log tell of quadrics without their cloud",
          "[process][pairing]") {
  std::map<std::string, std::vector<Message>> published;
  DetectorNode detector({}, keep_in(published));
  const Message here = encode_ball(-0.1), there = encode_ball(0.1);
  for (const Message& cloud : {here, there}) give(detector, "POINT_CLOUD", cloud);
  PlannerNode planner(planner_settings(), keep_in(published));
  for (const Message& cloud : {here, here}) give(planner, "POINT_CLOUD", cloud);
  for (const Message& quadrics : published["QUADRICS"]) give(planner, "QUADRICS", quadrics);
  planner.publish_status({});
  planner_status_t status;
  const Message& bytes = published.at("QUADRILLE_PLANNER_STATUS").at(0);
  REQUIRE(status.decode(bytes.data(), 0, static_cast<int>(bytes.size())) > 0);
  REQUIRE(status.unpaired.size() == 1);
  CHECK(status.unpaired[0].name == "other_cloud");
  const std::vector<std::string> oddities = planner.find_oddities();
  REQUIRE(oddities.size() == 2);
  CHECK(oddities[0].find("1 of 2 messages of quadrics have no cloud of theirs (other_cloud 1)") ==
        0);
  CHECK(oddities[1].find("1 of 2 clouds have no quadrics") == 0);
}

}  // namespace quadrille
