#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::contains;
using test::Run;
using test::run_quadrille;
using test::TempFolder;

namespace {

std::string table_in(const TempFolder& folder) {
  const std::string path = folder.path("table.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 3 " + path).code == 0);
  return path;
}

/// The only object that a command writes.
json object_of(const std::string& arguments) {
  const Run run = run_quadrille(arguments);
  INFO(run.err);
  REQUIRE(run.code == 0);
  return json::parse(run.out);
}

/// Settings of JSON as a configuration file.
std::string toml_from(const json& settings) {
  std::string text;
  for (const auto& [key, value] : settings.items()) text += key + " = " + value.dump() + "\n";
  return text;
}

/// The sentences that a run printed as warnings, without the program and the input before them.
std::vector<std::string> printed_warnings(const Run& run) {
  const std::string mark = ": warning: ";
  std::vector<std::string> sentences;
  std::istringstream lines(run.err);
  for (std::string line; std::getline(lines, line);) {
    const auto at = line.find(mark);
    if (at != std::string::npos) sentences.push_back(line.substr(at + mark.size()));
  }
  return sentences;
}

}  // namespace

TEST_CASE("JSON names the program's version, the seed and the hand", "[json][command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", test::ply_of({"1 2 3"}));
  const json found = object_of("detect --json - --seed 18446744073709551615 " + cloud);
  CHECK(run_quadrille("--version").out ==
        "quadrille " + found["version"].get<std::string>() + "\n");
  CHECK(found["seed"] == 18446744073709551615U);
  CHECK_FALSE(found.contains("gripper"));
  const std::string hand = folder.write("mine.toml", run_quadrille("gripper wsg50").out);
  const json plan = object_of("plan --json - --gripper " + hand + " " + cloud);
  CHECK(plan["gripper"] == "wsg50");
  CHECK(plan["seed"] == 1);
}

TEST_CASE("JSON has the settings that differ from the default, and no others", "[json][command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", test::ply_of({"1 2 3"}));
  CHECK(object_of("detect --json - " + cloud)["settings"] == json::object());
  CHECK(object_of("plan --gripper franka --json - " + cloud)["settings"] == json::object());
  // The last one is what it is by default.
  const std::string config = folder.write(
      "c.toml",
      "seed = 9\n[planes]\nleast_samples = 50\n[track]\ngate = 3.5\n[planner]\napproach = 0.25\n"
      "friction = 0.5\n");
  const json of_detect = {
      {"seed", 9}, {"planes.min_samples", 50}, {"track.gate", 3.5}, {"threads", 2}};
  CHECK(object_of("detect --threads 2 --json - --config " + config + " " + cloud)["settings"] ==
        of_detect);
  const json of_plan = {{"seed", 9},
                        {"planes.min_samples", 50},
                        {"planner.approach", 0.25},
                        {"report", {"cone", "sphere"}},
                        {"planner.unknown", "free"}};
  CHECK(object_of("plan --gripper franka --unknown free --only cone,sphere --json - --config " +
                  config + " " + cloud)["settings"] == of_plan);
}

TEST_CASE("seed and settings of JSON, read back as a file, give the same plan",
          "[json][command][determinism]") {
  const TempFolder folder;
  const std::string plan = "plan --gripper franka --json - " + table_in(folder) + " ";
  const std::string config =
      folder.write("c.toml", "[search]\nbases = 4\n[planner]\nfriction = 0.3\n");
  json first = object_of(plan + "--seed 5 --report sphere,cylinder --config " + config);
  const std::string again = folder.write("again.toml", toml_from(first["settings"]));
  json second = object_of(plan + "--config " + again);
  json other = object_of(plan);
  for (json* object : {&first, &second, &other}) object->erase("timings");
  CHECK(second == first);
  CHECK(other["grasps"] != first["grasps"]);
}

TEST_CASE("JSON has all that is printed as warnings about its input", "[json][command]") {
  const TempFolder folder;
  CHECK(object_of("detect --json - " + table_in(folder))["warnings"] == json::array());
  // Millimetres for metres.
  std::vector<std::string> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back(std::to_string(i % 20 * 10) + " " + std::to_string(i / 20 * 10) + " 900");
  }
  const std::string cloud = folder.write("mm.ply", test::ply_of(points));
  const Run run = run_quadrille("detect --json - --only sphere " + cloud);
  const auto printed = printed_warnings(run);
  REQUIRE_FALSE(printed.empty());
  CHECK(json::parse(run.out)["warnings"] == json(printed));
  const Run plan = run_quadrille("plan --gripper franka --json - " + cloud);
  CHECK(json::parse(plan.out)["warnings"] == json(printed_warnings(plan)));
  CHECK_FALSE(printed_warnings(plan).empty());
}

TEST_CASE("JSON has what was asked for, and nothing where all was", "[json][command][query]") {
  const TempFolder folder;
  const std::string plan = "plan --gripper franka --json - " + table_in(folder);
  CHECK(object_of(plan)["query"] == json::object());
  const json asked = object_of(plan + " --target 1,2 --near 0.1,0,0.8 --max-size 0.3 --best 2" +
                               " --approach 0,0,2,90")["query"];
  CHECK(asked["target"] == json({1, 2}));
  CHECK(asked["near"] == json({0.1, 0.0, 0.8}));
  CHECK(asked["max_size"] == 0.3);
  CHECK(asked["best"] == 2);
  CHECK(asked["approach"]["direction"] == json({0.0, 0.0, 1.0}));
  CHECK(asked["approach"]["angle"].get<double>() == Approx(1.5707963267948966));
  CHECK(asked.size() == 5);
}

TEST_CASE("the arm and the number of grasps of each target are settings of a plan",
          "[json][command][query]") {
  const TempFolder folder;
  const std::string plan = "plan --gripper franka --json - " + table_in(folder);
  const json all = object_of(plan + " --per-target 30 --best 1000");
  CHECK(all["settings"]["planner.per_target"] == 30);
  std::map<int, int> counts;
  for (const json& grasp : all["grasps"]) ++counts[grasp["target"].get<int>()];
  REQUIRE_FALSE(counts.empty());
  int most = 0;
  for (const auto& [target, count] : counts) most = std::max(most, count);
  CHECK(most > 12);
  CHECK(most <= 30);
  // Plan without a reach first, to learn where the grasps lie.
  const json p = all["grasps"][0]["X_CG"]["position"];
  const std::string base = p[0].dump() + "," + p[1].dump() + "," + p[2].dump();
  const json near = object_of(plan + " --reach=" + base + ",0,0.06");
  CHECK(near["settings"]["planner.reach.max"] == 0.06);
  CHECK(near["rejected"]["reach"] > 0);
  REQUIRE_FALSE(near["grasps"].empty());
  for (const json& grasp : near["grasps"]) {
    for (const char* pose : {"X_CG", "pregrasp"}) {
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        const double off = grasp[pose]["position"][axis].get<double>() - p[axis].get<double>();
        square += off * off;
      }
      CHECK(square <= 0.06 * 0.06 + 1e-12);
    }
  }
  // The base stands still in the frame of the results if the camera has a pose in it.
  const json moved = object_of(plan + " --camera-pose=0,0,0,1,0,0,0 --reach=" + base + ",0,0.06");
  CHECK(moved["grasps"].size() == near["grasps"].size());
  const json far = object_of(plan + " --reach=0,0,-50,0,1");
  CHECK(far["grasps"].empty());
  CHECK(far["rejected"]["reach"] > 0);
}

TEST_CASE("conditions that contradict each other are wrong usage", "[command][query]") {
  const TempFolder folder;
  const std::string plan = "plan --gripper franka " + table_in(folder);
  for (const std::string wrong :
       {"--min-size nan", "--min-size 0.5 --max-size 0.3", "--max-size -1", "--approach 0,0,0,10",
        "--approach 0,0,1,0", "--roi 1,1,1,0,0,0", "--near 1,2", "--best 0", "--target x",
        "--min-clearance 0.5", "--per-target -1", "--reach 0,0,0,1", "--reach 0,0,0,2,1",
        "--reach 0,0,0,0,nan", "--reach=0,-1e9,0,0,1"}) {
    CAPTURE(wrong);
    CHECK(run_quadrille(plan + " " + wrong).code == 2);
  }
  CHECK(run_quadrille(plan + " --approach 1e200,0,0,10").code == 0);
}

TEST_CASE("plans of a log's clouds tell tracks, and can be asked for some", "[command][query]") {
  const TempFolder folder;
  const std::string table = table_in(folder), log = folder.path("o.lcm");
  REQUIRE(run_quadrille("log " + log + " " + table + " " + table).code == 0);
  const auto objects_of = [](const std::string& arguments) {
    const Run run = run_quadrille(arguments);
    REQUIRE(run.code == 0);
    std::vector<json> objects;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) objects.push_back(json::parse(line));
    return objects;
  };
  const std::string plan = "plan --gripper franka --json - " + log;
  const auto found = objects_of("detect --json - " + log), planned = objects_of(plan);
  REQUIRE(found.size() == 2);
  REQUIRE(planned.size() == 2);
  for (int n : {0, 1}) {
    // A box or a lump has the track of its body.
    std::map<int, int> tracks;
    for (const json& body : found[n]["bodies"]) tracks[body["id"]] = body["track"];
    for (const json& d : found[n]["detections"]) tracks[d["id"]] = d["track"];
    REQUIRE_FALSE(planned[n]["grasps"].empty());
    for (const json& grasp : planned[n]["grasps"]) {
      CHECK(grasp["track"] == tracks[grasp["target"]]);
    }
  }
  const int track = planned[1]["grasps"][0]["track"];
  REQUIRE(track > 0);
  const auto asked = objects_of(plan + " --tracks " + std::to_string(track));
  for (const json& object : asked) {
    CHECK_FALSE(object["grasps"].empty());
    for (const json& grasp : object["grasps"]) CHECK(grasp["track"] == track);
  }
}
