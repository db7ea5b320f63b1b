// Logs of a moving camera, and files of several, as views of one scene.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

namespace quadrille {
namespace {

using nlohmann::json;
using test::check_failure;
using test::contains;
using test::Run;
using test::run_quadrille;

/// A log of a camera that moves round a table.
class PathLog {
 public:
  explicit PathLog(int clouds) {
    REQUIRE(run_quadrille("scene " + path() + " --family tabletop --seed 4 --rate 1 --path " +
                          std::to_string(clouds))
                .code == 0);
  }
  std::string path() const { return folder_.path("path.lcm"); }
  std::string beside(const std::string& name) const { return folder_.path(name); }
  std::string posed() const { return path() + " --pose-channel CAMERA_POSE"; }

 private:
  const test::TempFolder folder_;
};

std::vector<json> objects_of(const Run& run) {
  INFO(run.err);
  REQUIRE(run.code == 0);
  std::vector<json> objects;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) objects.push_back(json::parse(line));
  return objects;
}

std::vector<json> plan(const std::string& arguments) {
  return objects_of(
      run_quadrille("plan --gripper franka --unknown obstacle --json - " + arguments));
}

int unknown(const json& plan) { return plan["rejected"].value("unknown", 0); }

TEST_CASE("what earlier clouds of a scene showed is known in later plans", "[command][scene]") {
  const PathLog log(4);
  const std::vector<json> alone = plan(log.posed()), lasting = plan(log.posed() + " --scene");
  REQUIRE(alone.size() == 4);
  REQUIRE(lasting.size() == 4);
  CHECK(unknown(lasting[0]) == unknown(alone[0]));
  CHECK(unknown(alone[3]) > 0);
  CHECK(unknown(lasting[3]) < unknown(alone[3]));
  // One cloud by its number has all before it.
  const std::vector<json> last = plan(log.path() + "#4 --scene --pose-channel CAMERA_POSE");
  REQUIRE(last.size() == 1);
  CHECK(unknown(last[0]) == unknown(lasting[3]));
  CHECK(last[0]["grasps"].size() == lasting[3]["grasps"].size());
}

TEST_CASE("the poses of a log place its things in the fixed frame, where they keep their tracks",
          "[command][scene]") {
  const PathLog log(4);
  const std::vector<json> clouds =
      objects_of(run_quadrille("detect --json - --scene " + log.posed()));
  REQUIRE(clouds.size() == 4);
  std::map<int, std::vector<json>> of_track;
  for (const json& cloud : clouds) {
    CHECK(cloud["frame"] == "world");
    for (const json& detection : cloud["detections"]) {
      if (detection["type"] == "plane") continue;
      of_track[detection["track"].get<int>()].push_back(detection["pose"]["position"]);
    }
  }
  int lasting = 0;
  for (const auto& [track, positions] : of_track) {
    if (positions.size() < 3) continue;
    ++lasting;
    for (const json& position : positions) {
      for (int i = 0; i < 3; ++i) {
        CAPTURE(track, i);
        CHECK(position[i].get<double>() == Approx(positions.front()[i].get<double>()).margin(0.03));
      }
    }
  }
  CHECK(lasting >= 2);
}

/// How far the largest plane of a cloud, its table, lies from the frame's origin [m].
double distance_of_table(const json& cloud) {
  double distance = 0.0;
  int most = 0;
  for (const json& detection : cloud["detections"]) {
    if (detection["type"] != "plane" || detection["inliers"].get<int>() <= most) continue;
    most = detection["inliers"].get<int>();
    const std::vector<double> q = detection["q"];
    distance = std::abs(q[9]) / (2.0 * std::hypot(q[6], q[7], q[8]));
  }
  return distance;
}

TEST_CASE(
    "a table that several clouds show is at one place in the fixed frame, though poses are off",
    "[command][scene]") {
  const test::TempFolder folder;
  const std::string log = folder.path("off.lcm");
  REQUIRE(run_quadrille("scene " + log +
                        " --family tabletop --seed 4 --rate 1 --path 4 --pose-error 0.003,0.3")
              .code == 0);
  // The largest difference from where the first cloud shows it.
  const auto largest_shift = [&](const std::string& arguments) {
    const std::vector<json> clouds = objects_of(
        run_quadrille("detect --json - " + log + " --pose-channel CAMERA_POSE" + arguments));
    REQUIRE(clouds.size() == 4);
    const double first = distance_of_table(clouds.front());
    double shift = 0.0;
    for (const json& cloud : clouds) {
      shift = std::max(shift, std::abs(distance_of_table(cloud) - first));
    }
    return shift;
  };
  CHECK(largest_shift("") > 0.004);
  CHECK(largest_shift(" --scene") < 0.0015);
}

TEST_CASE("clouds without a pose are left out, and the reason is told", "[command][scene]") {
  const PathLog log(2);
  const Run run = run_quadrille("detect --json - " + log.path() + " --pose-channel NOBODY");
  check_failure(run, "2 of 2 clouds are left out, since the pose of their camera is not known");
  CHECK(run.out.empty());
  CHECK(contains(run.err, "no pose has come; is --pose-channel right"));
  check_failure(run_quadrille("detect " + log.path() + "#2 --pose-channel NOBODY"),
                "the pose of the camera of cloud #2 is not known: no pose has come");
}

TEST_CASE("a scene of a log whose camera may have moved is warned of", "[command][scene]") {
  const PathLog log(2);
  const std::string hint = "as if their camera had not moved; name the channel of its poses";
  const auto warned = [&](const std::string& arguments) {
    const Run run = run_quadrille("detect --json - " + arguments);
    CHECK(run.code == 0);
    const json last = objects_of(run).back();
    const bool in_json = contains(last["warnings"].dump(), hint);
    CHECK(in_json == contains(run.err, hint));
    return in_json;
  };
  CHECK(warned(log.path() + " --scene"));
  CHECK(warned(log.path() + "#2 --scene"));
  CHECK_FALSE(warned(log.path() + "#1 --scene"));
  CHECK_FALSE(warned(log.path()));
  CHECK_FALSE(warned(log.posed() + " --scene"));
  CHECK_FALSE(warned(log.path() + " --scene --camera-pose 0,0,0,1,0,0,0"));
}

TEST_CASE("the map of a scene is that of its last cloud", "[command][scene]") {
  const PathLog log(3);
  const std::string map = log.beside("map.bt"), named = log.beside("named.bt");
  const std::string options = " --scene --pose-channel CAMERA_POSE --map ";
  CHECK(run_quadrille("plan --gripper franka " + log.path() + options + map).code == 0);
  CHECK(run_quadrille("plan --gripper franka " + log.path() + "#3" + options + named).code == 0);
  CHECK(std::filesystem::file_size(map) > 1000);
  CHECK(test::content_of(map) == test::content_of(named));
  CHECK(run_quadrille("plan --gripper franka " + log.path() + "#2" + options + named).code == 0);
  CHECK(test::content_of(map) != test::content_of(named));
}

TEST_CASE("files of several cameras are views of one scene", "[command][scene]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply"), other = folder.path("b.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 4 " + cloud).code == 0);
  std::filesystem::copy_file(cloud, other);
  const std::string pose = " --camera-pose 0,0,0,1,0,0,0";
  const std::vector<json> plans = plan(cloud + " " + other + " --scene" + pose + pose);
  REQUIRE(plans.size() == 2);
  CHECK(plans[0]["detections"][0]["track"] == plans[1]["detections"][0]["track"]);
  CHECK(plan(cloud + pose).front()["grasps"].size() == plans[0]["grasps"].size());
  const Run run = run_quadrille("detect " + cloud + pose + pose);
  CHECK(run.code == 2);
  CHECK(contains(run.err, "is given 2 times for 1 INPUTs"));
}

TEST_CASE("options of a scene that do not fit together are refused", "[command][scene]") {
  const PathLog log(2);
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  REQUIRE(run_quadrille("scene --family easy --seed 1 " + cloud).code == 0);
  for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{
           {cloud + " --pose-channel P", "is for LCM logs"},
           {log.posed() + " --viewpoint 0,0,0", "excludes"},
           {log.posed() + " --camera-pose 0,0,0,1,0,0,0", "excludes"},
           {log.path() + "#1 --scene --view " + cloud, "excludes"}}) {
    CAPTURE(arguments);
    const Run run = run_quadrille("detect " + arguments);
    CHECK(run.code == 2);
    CHECK(contains(run.err, part));
  }
}

}  // namespace
}  // namespace quadrille
