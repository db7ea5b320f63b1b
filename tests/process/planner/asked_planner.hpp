#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <lcmtypes/quadrille/grasp_request_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/occupancy_t.hpp>
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "process/planner/command_line.hpp"
#include "process/planner/node.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

using Bytes = std::vector<std::byte>;

/// Two balls and a can on a table, seen by a camera.
inline const PointCloud& asked_cloud() {
  static const PointCloud cloud = [] {
    const Eigen::Isometry3d X_KT = world_seen_from({0.5, 0.1, 0.5});
    std::vector<Patch> patches = can(X_KT * translation(0, 0, 0.05), 0.03, 0.1);
    patches.push_back(sphere(X_KT * translation(0.02, 0.15, 0.03), 0.03));
    patches.push_back(sphere(X_KT * translation(0.02, -0.15, 0.025), 0.025));
    patches.push_back(rectangle(X_KT, 2.0, 2.0));
    Camera camera;
    camera.noise = 0.0005;
    PointCloud made = render(patches, camera);
    made.frame = "eye";
    return made;
  }();
  return cloud;
}

inline const DetectionResult& asked_found() {
  static const DetectionResult found = detect(asked_cloud());
  return found;
}

/// A planner's process, which is given clouds with their quadrics, and requests.
class Asked {
 public:
  /// Without a deadline, so that a slow machine changes no answer.
  explicit Asked(const std::string& options = "")
      : node_(settings_from("--deadline-ms 0 " + options), keep()) {}

  void show(std::int64_t utime) {
    const bus::CloudMessage cloud{utime, 0, asked_cloud()};
    give("POINT_CLOUD", bus::encode_cloud(cloud, bus::CloudFormat::kDrake));
    give("QUADRICS", bus::encode(bus::to_message(cloud, asked_found())));
  }
  grasps_t ask(const grasp_request_t& request) {
    give("GRASP_REQUEST", bus::encode(request));
    REQUIRE_FALSE(answers.empty());
    CHECK(answers.back().request_id == request.request_id);
    return answers.back();
  }
  planner_status_t status() {
    node_.publish_status({});
    return status_;
  }
  void give(const std::string& channel, const Bytes& bytes) {
    if (const auto job = node_.receive(channel, bytes)) node_.work(*job);
  }

  PlannerNode& node() { return node_; }

  /// All grasps that were published.
  std::vector<grasps_t> answers;
  std::multiset<std::string> channels;
  /// Of the cloud of the last map.
  std::int64_t map_utime = 0;

 private:
  static PlannerSettings settings_from(const std::string& options) {
    CLI::App app;
    const PlannerCommandLine command_line(app);
    app.parse(options);
    return command_line.settings();
  }
  bus::Publish keep() {
    return [this](const std::string& channel, std::span<const std::byte> bytes) {
      const int size = static_cast<int>(bytes.size());
      channels.insert(channel);
      if (channel == "GRASPS")
        REQUIRE(answers.emplace_back().decode(bytes.data(), 0, size) == size);
      occupancy_t map{};
      if (channel == "OCCUPANCY") {
        REQUIRE(map.decode(bytes.data(), 0, size) == size);
        map_utime = map.utime;
      }
      if (channel == "QUADRILLE_PLANNER_STATUS")
        REQUIRE(status_.decode(bytes.data(), 0, size) == size);
    };
  }

  planner_status_t status_{};
  PlannerNode node_;
};

inline grasp_request_t request_of(std::int64_t id) {
  grasp_request_t request{};
  request.request_id = id;
  return request;
}

inline std::set<int> targets_of(const grasps_t& message) {
  std::set<int> targets;
  for (const grasp_t& grasp : message.grasps) targets.insert(grasp.target);
  return targets;
}

inline const Detection& a_sphere() {
  for (const Detection& d : asked_found().detections) {
    if (d.type == QuadricType::kSphere) return d;
  }
  throw std::runtime_error("no sphere was found");
}

}  // namespace quadrille::test
