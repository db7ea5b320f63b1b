// Requests for grasps and their answers.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <lcmtypes/quadrille/grasp_request_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/occupancy_t.hpp>
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <map>
#include <set>
#include <thread>
#include <vector>

#include "process/planner/command_line.hpp"
#include "process/planner/node.hpp"
#include "process/planner/recent_pairs.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

using Bytes = std::vector<std::byte>;

/// Two balls and a can on a table, seen by a camera.
const PointCloud& asked_cloud() {
  static const PointCloud cloud = [] {
    const Eigen::Isometry3d X_KT = test::world_seen_from({0.5, 0.1, 0.5});
    std::vector<test::Patch> patches = test::can(X_KT * test::translation(0, 0, 0.05), 0.03, 0.1);
    patches.push_back(test::sphere(X_KT * test::translation(0.02, 0.15, 0.03), 0.03));
    patches.push_back(test::sphere(X_KT * test::translation(0.02, -0.15, 0.025), 0.025));
    patches.push_back(test::rectangle(X_KT, 2.0, 2.0));
    test::Camera camera;
    camera.noise = 0.0005;
    PointCloud made = test::render(patches, camera);
    made.frame = "eye";
    return made;
  }();
  return cloud;
}

const DetectionResult& asked_found() {
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

grasp_request_t request_of(std::int64_t id) {
  grasp_request_t request{};
  request.request_id = id;
  return request;
}

std::set<int> targets_of(const grasps_t& message) {
  std::set<int> targets;
  for (const grasp_t& grasp : message.grasps) targets.insert(grasp.target);
  return targets;
}

const Detection& a_sphere() {
  for (const Detection& d : asked_found().detections) {
    if (d.type == QuadricType::kSphere) return d;
  }
  throw std::runtime_error("no sphere was found");
}

TEST_CASE("a request is answered with its id by what it asks for", "[process][request]") {
  Asked asked("--on-request");
  asked.show(1000);
  CHECK(asked.answers.empty());
  const grasps_t all = asked.ask(request_of(5));
  CHECK(all.utime == 1000);
  CHECK(all.frame == "eye");
  CHECK(targets_of(all).size() >= 3);
  grasp_request_t request = request_of(6);
  request.targets = {a_sphere().id};
  request.num_targets = 1;
  request.max_grasps = 2;
  const grasps_t one = asked.ask(request);
  CHECK(targets_of(one) == std::set{a_sphere().id});
  CHECK(one.grasps.size() == 2);
  // Nothing but the grasps is sent.
  CHECK(asked.channels.count("GRASPS") == asked.channels.size());
  const planner_status_t status = asked.status();
  CHECK(status.requests == 2);
  CHECK(status.answered == 2);
  CHECK(status.unmet == 0);
}

TEST_CASE("a request may bring a number of grasps of each target, and a score",
          "[process][request]") {
  Asked asked("--on-request --per-target 2 --min-score 0");
  asked.show(1000);
  const auto most_of_one = [](const grasps_t& answer) {
    std::map<int, int> counts;
    int most = 0;
    for (const grasp_t& grasp : answer.grasps) most = std::max(most, ++counts[grasp.target]);
    return most;
  };
  CHECK(most_of_one(asked.ask(request_of(1))) == 2);
  grasp_request_t request = request_of(2);
  request.per_target = 5;
  CHECK(most_of_one(asked.ask(request)) == 5);
  request.request_id = 3;
  request.min_score = asked.answers.back().grasps.front().score;
  const grasps_t good = asked.ask(request);
  REQUIRE_FALSE(good.grasps.empty());
  for (const grasp_t& grasp : good.grasps) CHECK(grasp.score >= request.min_score);
  request.min_score = 1.5;
  CHECK(asked.ask(request).warnings.back() == "min_score = 1.5: must be 0 to 1");
  request.min_score = 0.0;
  request.per_target = -1;
  CHECK(asked.ask(request).warnings.back() == "per_target = -1: must be 0 or more");
}

TEST_CASE("an arm's reach may be in any frame that is known, and wins over that of the settings",
          "[process][request][reach]") {
  const Eigen::Isometry3d X_WK =
      Eigen::Translation3d(1.0, -0.5, 0.75) * Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  const Eigen::Vector3d p_K = a_sphere().X_CQ.translation(), p_W = X_WK * p_K;
  const std::string pose = "--on-request --camera-pose=1,-0.5,0.75,0.5,0.5,-0.5,0.5 ";
  // By the settings nothing is within reach.
  Asked asked(pose + "--reach=9,9,9,0,1");
  asked.show(1000);
  const grasps_t none = asked.ask(request_of(1));
  CHECK(none.grasps.empty());
  CHECK(std::any_of(none.rejected.begin(), none.rejected.end(),
                    [](const count_t& entry) { return entry.name == "reach"; }));
  // No approach is longer than 10 cm, and nothing else is so near the sphere.
  for (const std::string frame : {"", "eye", "camera", "world"}) {
    CAPTURE(frame);
    grasp_request_t request = request_of(1);
    request.frame = frame;
    request.has_reach = 1;
    Eigen::Map<Eigen::Vector3d>(request.reach_base) = frame == "world" ? p_W : p_K;
    request.reach_max = 0.1;
    CHECK(targets_of(asked.ask(request)) == std::set{a_sphere().id});
  }
  // By these settings it is the sphere that is.
  Asked near(pose + "--reach=" + std::to_string(p_W.x()) + "," + std::to_string(p_W.y()) + "," +
             std::to_string(p_W.z()) + ",0,0.1");
  near.show(1000);
  CHECK(targets_of(near.ask(request_of(1))) == std::set{a_sphere().id});
  // Without a fixed frame the settings are in the camera's.
  Asked unplaced("--on-request --reach=" + std::to_string(p_K.x()) + "," + std::to_string(p_K.y()) +
                 "," + std::to_string(p_K.z()) + ",0,0.1");
  unplaced.show(1000);
  CHECK(targets_of(unplaced.ask(request_of(1))) == std::set{a_sphere().id});
  grasp_request_t request = request_of(9);
  request.has_reach = 1;
  CHECK(unplaced.ask(request).warnings.back().find("reach's greatest distance = 0: must be") == 0);
}

TEST_CASE("a request may bring a deadline of its own", "[process][request][deadline]") {
  Asked asked("--on-request");
  asked.show(1000);
  grasp_request_t hasty = request_of(1);
  hasty.deadline_ms = 1e-6;
  const grasps_t cut = asked.ask(hasty);
  CHECK(cut.grasps.empty());
  CHECK(std::any_of(cut.rejected.begin(), cut.rejected.end(),
                    [](const count_t& entry) { return entry.name == "deadline"; }));
  CHECK(asked.status().cut == 1);
  // The next one gets all, though the scene of the last one lacked its targets, and so does the one
  // after it, on the scene that is kept: a deadline is for one request alone.
  CHECK(targets_of(asked.ask(request_of(2))).size() >= 3);
  hasty.request_id = 3;
  CHECK(asked.ask(hasty).grasps.empty());
  CHECK(targets_of(asked.ask(request_of(4))).size() >= 3);
  CHECK(asked.status().cut == 2);
}

TEST_CASE("each cloud is planned on as well unless told otherwise", "[process][request]") {
  Asked asked;
  asked.show(1000);
  REQUIRE(asked.answers.size() == 1);
  CHECK(asked.answers[0].request_id == 0);
  const grasps_t same = asked.ask(request_of(1));
  REQUIRE(same.grasps.size() == asked.answers[0].grasps.size());
  for (std::size_t n = 0; n < same.grasps.size(); ++n) {
    CHECK(same.grasps[n].score == asked.answers[0].grasps[n].score);
  }
}

TEST_CASE("an older cloud can be named, and one that is gone is told of", "[process][request]") {
  Asked asked("--on-request");
  CHECK(asked.ask(request_of(1)).warnings.at(0) == "no cloud has come with its quadrics yet");
  for (std::int64_t utime = 1; utime <= 40; ++utime) asked.show(utime);
  CHECK(asked.ask(request_of(2)).utime == 40);
  grasp_request_t request = request_of(3);
  request.cloud_utime = 20;
  CHECK(asked.ask(request).utime == 20);
  request.cloud_utime = 2;
  const grasps_t gone = asked.ask(request);
  CHECK(gone.grasps.empty());
  CHECK(gone.warnings.at(0).find("cloud 2 is not kept") == 0);
  CHECK(asked.status().unmet == 2);
}

TEST_CASE("places in a request may be in any frame that is known", "[process][request]") {
  const Eigen::Isometry3d X_WK =
      Eigen::Translation3d(1.0, -0.5, 0.75) * Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  Asked asked("--on-request --camera-pose=1,-0.5,0.75,0.5,0.5,-0.5,0.5");
  asked.show(1000);
  const Eigen::Vector3d p_K = a_sphere().X_CQ.translation(), p_W = X_WK * p_K;
  for (const std::string frame : {"", "eye", "camera", "world"}) {
    CAPTURE(frame);
    grasp_request_t request = request_of(1);
    request.frame = frame;
    request.has_near = 1;
    Eigen::Map<Eigen::Vector3d>(request.near) = frame == "world" ? p_W : p_K;
    CHECK(targets_of(asked.ask(request)) == std::set{a_sphere().id});
    // A slim box about it, turned about its middle.
    request.has_near = 0;
    request.has_region = 1;
    std::copy_n(request.near, 3, request.region.position);
    const double q[] = {0.8, 0.0, 0.6, 0.0};
    std::copy_n(q, 4, request.region.quaternion);
    std::fill_n(request.region_size, 3, 0.01);
    CHECK(targets_of(asked.ask(request)) == std::set{a_sphere().id});
  }
  Asked unplaced("--on-request");
  unplaced.show(1000);
  grasp_request_t request = request_of(1);
  request.frame = "world";
  CHECK(unplaced.ask(request).warnings.at(0).find("frame 'world' is not known: no pose") == 0);
  request.frame = "moon";
  CHECK(unplaced.ask(request).warnings.at(0).find("frame 'moon' is not known: name") == 0);
}

TEST_CASE("a request that cannot be met is answered with the reason", "[process][request]") {
  Asked asked("--on-request");
  asked.show(1000);
  const auto why = [&](const grasp_request_t& request) {
    const grasps_t answer = asked.ask(request);
    CHECK(answer.grasps.empty());
    REQUIRE_FALSE(answer.warnings.empty());
    return answer.warnings.back();
  };
  grasp_request_t request = request_of(1);
  request.targets = {99};
  request.num_targets = 1;
  CHECK(why(request).find("no target of that id; there are:") == 0);
  request = request_of(2);
  request.types = {"teapot"};
  request.num_types = 1;
  CHECK(why(request) == "types: 'teapot' is no type");
  request = request_of(3);
  request.has_approach = 1;
  CHECK(why(request) == "approach: must not be 0");
  request = request_of(4);
  request.has_region = 1;
  CHECK(why(request).find("region.quaternion has norm 0") == 0);
  request = request_of(5);
  request.min_clearance = std::numeric_limits<double>::quiet_NaN();
  CHECK(why(request).find("min_clearance") == 0);
}

TEST_CASE("damaged requests are counted and answered by nothing", "[process][request][hostile]") {
  Asked asked("--on-request");
  asked.show(1000);
  Bytes bytes = bus::encode(request_of(1));
  bytes.pop_back();
  asked.give("GRASP_REQUEST", bytes);
  CHECK(asked.answers.empty());
  asked.give("GRASP_REQUEST", bus::encode(request_of(0)));
  CHECK(asked.answers.empty());
  const planner_status_t status = asked.status();
  CHECK(status.requests == 2);
  REQUIRE(status.rejected_requests.size() == 2);
  for (const count_t& rejected : status.rejected_requests) CHECK(rejected.count == 1);
}

TEST_CASE("requests are jobs that no newer one replaces", "[process][request]") {
  Asked asked("--on-request");
  asked.show(1000);
  const auto job = asked.node().receive("GRASP_REQUEST", bus::encode(request_of(8)));
  REQUIRE(job);
  REQUIRE(job->refuse);
  job->refuse("the queue is full");
  REQUIRE(asked.answers.size() == 1);
  CHECK(asked.answers[0].request_id == 8);
  CHECK(asked.answers[0].warnings.at(0) == "the queue is full");
}

TEST_CASE("pairs are kept within their bounds, the newest always", "[process][request]") {
  const auto pair = [](std::int64_t utime, std::size_t points) {
    auto cloud = std::make_shared<bus::CloudMessage>();
    cloud->utime = utime;
    cloud->cloud.points.resize(points);
    auto made = std::make_shared<CloudAndQuadrics>();
    made->cloud = cloud;
    return made;
  };
  RecentPairs pairs(3, 1200);
  CHECK(pairs.newest() == nullptr);
  for (int k = 1; k <= 5; ++k) pairs.add(pair(k, 10));
  CHECK(pairs.size() == 3);
  CHECK(pairs.find(2) == nullptr);
  CHECK(pairs.find(3)->cloud->utime == 3);
  pairs.add(pair(6, 1000));
  CHECK(pairs.size() == 1);
  CHECK(pairs.newest()->cloud->utime == 6);
}

TEST_CASE("the newest map is published when clouds stop coming", "[planner][process]") {
  Asked asked("--occupancy-period 1");
  asked.show(1);
  asked.show(2);
  for (int tries = 0; tries < 1000 && asked.channels.count("OCCUPANCY") < 2; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (const auto job = asked.node().find_spare_job()) asked.node().work(*job);
  }
  CHECK(asked.channels.count("OCCUPANCY") == 2);
  CHECK(asked.map_utime == 2);
  CHECK_FALSE(asked.node().find_spare_job());
}

TEST_CASE("shapes come with each plan and occupancy at its own pace, or not at all",
          "[planner][process]") {
  using Channels = std::multiset<std::string>;
  // An hour: the second plan comes sooner.
  Asked often("--occupancy-period 3600");
  often.show(1);
  often.show(2);
  CHECK(often.channels ==
        Channels{"GRASPS", "GRASPS", "COLLISION_SHAPES", "COLLISION_SHAPES", "OCCUPANCY"});
  Asked each("--occupancy-period 0");
  each.show(1);
  each.show(2);
  CHECK(each.channels.count("OCCUPANCY") == 2);
  Asked neither("--no-shapes --no-occupancy");
  neither.show(1);
  CHECK(neither.channels == Channels{"GRASPS"});
}

}  // namespace
}  // namespace quadrille
