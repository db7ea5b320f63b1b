#include <nlohmann/json.hpp>
#include <sstream>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::check_failure;
using test::contains;
using test::Run;
using test::run_quadrille;

namespace {

/// A generated scene as a file.
std::string make_scene(const test::TempFolder& folder, int seed) {
  const std::string path = folder.path("scene_" + std::to_string(seed) + ".ply");
  REQUIRE(run_quadrille("scene --family easy --seed " + std::to_string(seed) + " " + path).code ==
          0);
  return path;
}

/// Clouds as a log of the given type.
std::string make_log(const test::TempFolder& folder, const std::string& clouds,
                     const std::string& type = "drake") {
  const std::string path = folder.path(type + ".lcm");
  REQUIRE(run_quadrille("log " + path + " " + clouds + " --as " + type).code == 0);
  return path;
}

/// One JSON object a line, without what may differ: the input's name, the times and the
/// number of threads.
std::vector<json> comparable(const Run& run) {
  INFO(run.err);
  REQUIRE(run.code == 0);
  std::vector<json> objects;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    objects.push_back(json::parse(line));
    objects.back().erase("input");
    objects.back().erase("timings");
    objects.back()["settings"].erase("threads");
  }
  return objects;
}

/// Files have no tracks.
std::vector<json> without_tracks(std::vector<json> objects) {
  for (json& object : objects) {
    for (const char* list : {"detections", "bodies", "grasps"}) {
      for (json& item : object[list]) item.erase("track");
    }
  }
  return objects;
}

std::vector<json> detect(const std::string& arguments) {
  return comparable(run_quadrille("detect --json - " + arguments));
}

}  // namespace

TEST_CASE("clouds through a log give what their files give, in all message types",
          "[command][log][determinism]") {
  const test::TempFolder folder;
  const std::string clouds = make_scene(folder, 3) + " " + make_scene(folder, 4);
  const std::vector<json> expected = detect("--track " + clouds);
  REQUIRE(expected.size() == 2);
  REQUIRE(expected[0]["detections"].size() >= 2);
  for (const char* type : {"drake", "pointcloud2", "pointcloud"}) {
    INFO(type);
    CHECK(detect(make_log(folder, clouds, type)) == expected);
  }
}

TEST_CASE("the number of threads never changes the result, from a file or a log",
          "[command][log][determinism]") {
  const test::TempFolder folder;
  const std::string cloud = make_scene(folder, 5);
  const std::string log = make_log(folder, cloud);
  const std::vector<json> expected = detect("--track --threads 1 " + cloud);
  REQUIRE(expected[0]["detections"].size() >= 2);
  for (const char* threads : {"--threads 2 ", "--threads 5 "}) {
    CHECK(detect(threads + ("--track " + cloud)) == expected);
    CHECK(detect(threads + log) == expected);
  }
}

TEST_CASE("clouds of a log have tracks, and files if they are successive views",
          "[command][log][track]") {
  const test::TempFolder folder;
  const std::string cloud = make_scene(folder, 3);
  const std::string twice = cloud + " " + cloud;
  for (const json& apart : detect(twice)) {
    for (const json& d : apart["detections"]) CHECK_FALSE(d.contains("track"));
  }
  const std::string log = make_log(folder, twice);
  const std::vector<json> tracked = detect(log);
  REQUIRE(tracked.size() == 2);
  REQUIRE(tracked[0]["detections"].size() >= 2);
  for (const json& d : tracked[0]["detections"]) CHECK(d["track"] == d["id"]);
  CHECK(tracked[0]["detections"] == tracked[1]["detections"]);
  // A log of its own is a sequence of its own.
  CHECK(detect(log + " " + log)[2] == tracked[0]);
  CHECK(contains(run_quadrille("detect " + log).out, "id  track  type"));
  CHECK_FALSE(contains(run_quadrille("detect " + cloud).out, "track"));
}

TEST_CASE("tracking is set up, and switched off, by the configuration", "[command][log][track]") {
  const test::TempFolder folder;
  const std::string cloud = make_scene(folder, 3);
  const std::string off = folder.write("off.toml", "[track]\nenabled = false\n");
  const json first = detect("--track --config " + off + " " + cloud)[0]["detections"][0];
  CHECK_FALSE(first.contains("track"));
  const std::string wrong = folder.write("wrong.toml", "[track]\ngate = 0\n");
  check_failure(run_quadrille("detect --config " + wrong + " " + cloud), "track.gate");
}

TEST_CASE("the clouds of a log are named by their number", "[command][log]") {
  const test::TempFolder folder;
  const std::string cloud = make_scene(folder, 3);
  const std::string log = make_log(folder, cloud + " " + cloud);
  std::istringstream lines(run_quadrille("detect --json - " + log).out);
  for (const char* number : {"#1", "#2"}) {
    std::string line;
    REQUIRE(std::getline(lines, line));
    CHECK(json::parse(line)["input"] == log + number);
  }
}

TEST_CASE("a log is known by its content where its name does not tell", "[command][log]") {
  const test::TempFolder folder;
  const std::string log = make_log(folder, make_scene(folder, 3));
  const std::string renamed = folder.write("lcmlog-2024-01-31.00", test::content_of(log));
  CHECK(detect(renamed) == detect(log));
}

TEST_CASE("plan makes of the clouds of a log what it makes of their files", "[command][log]") {
  const test::TempFolder folder;
  const std::string cloud = make_scene(folder, 3);
  const std::string plan = "plan --gripper franka --json - ";
  const Run through_log = run_quadrille(plan + make_log(folder, cloud));
  CHECK(without_tracks(comparable(through_log)) ==
        without_tracks(comparable(run_quadrille(plan + cloud))));
  const std::string two = make_log(folder, cloud + " " + cloud, "pointcloud2");
  CHECK(without_tracks(comparable(run_quadrille(plan + two))) ==
        without_tracks(comparable(run_quadrille(plan + cloud + " " + cloud))));
}

TEST_CASE("a damaged log gives its whole clouds and a warning", "[command][log][hostile]") {
  const test::TempFolder folder;
  const std::string cloud = make_scene(folder, 3);
  const std::string whole = test::content_of(make_log(folder, cloud + " " + cloud));
  const std::string cut = folder.write("cut.lcm", whole.substr(0, whole.size() - 100));
  const Run run = run_quadrille("detect --json - " + cut);
  CHECK(comparable(run).size() == 1);
  CHECK(contains(run.err, "warning: cut short at byte "));

  std::string wrong_length = whole;
  // A header of 28 bytes and the channel's name; then the fingerprint and the time, 8 bytes each,
  // and the length of the frame's name, whose first byte makes it negative.
  wrong_length[28 + std::string("POINT_CLOUD").size() + 16] = '\xff';
  const Run refused = run_quadrille("detect --json - " + folder.write("wrong.lcm", wrong_length));
  CHECK(comparable(refused).size() == 1);
  CHECK(contains(refused.err, "warning: refused 1 message: bad_length"));
  CHECK(json::parse(refused.out)["warnings"] == json({"refused 1 message: bad_length"}));
}

TEST_CASE("a log without clouds gives nothing but a warning", "[command][log][hostile]") {
  const test::TempFolder folder;
  const std::string empty = folder.write("empty.lcm", "");
  const Run run = run_quadrille("detect --json - " + empty);
  CHECK(run.code == 0);
  CHECK(run.out.empty());
  CHECK(contains(run.err, "holds no cloud"));
  const Run plan = run_quadrille("plan --gripper franka " + empty);
  CHECK(plan.code == 0);
  CHECK(contains(plan.err, "holds no cloud"));
}

TEST_CASE("what is no log ends the command with 1 and one line", "[command][log][hostile]") {
  const test::TempFolder folder;
  check_failure(run_quadrille("detect " + folder.path("none.lcm")), "none.lcm: no such file");
  check_failure(run_quadrille("detect " + folder.write("text.lcm", std::string(100, 'x'))),
                "is not an LCM log");
}
