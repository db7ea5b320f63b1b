#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "log/event_log.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::check_failure;
using test::contains;
using test::Run;
using test::run_quadrille;
using test::TempFolder;

namespace {

/// Two small clouds of different sizes, as files and in logs: both on one channel, and each on its
/// own.
struct TwoClouds {
  TempFolder folder;
  std::string small = folder.write("small.ply", test::ply_of({"1 2 3"}));
  std::string large = folder.write("large.ply", test::ply_of({"1 2 3", "1 2 4"}));
  std::string log = folder.path("both.lcm");
  std::string mixed = folder.path("mixed.lcm");

  TwoClouds() {
    REQUIRE(run_quadrille("log " + log + " " + small + " " + large).code == 0);
    const std::string left = folder.path("left.lcm"), right = folder.path("right.lcm");
    REQUIRE(run_quadrille("log --channel LEFT " + left + " " + small + " " + small).code == 0);
    REQUIRE(run_quadrille("log --channel RIGHT " + right + " " + large).code == 0);
    bus::LogWriter writer(mixed);
    for (const std::string& path : {left, right}) {
      bus::LogReader reader(path);
      while (const auto event = reader.next()) {
        writer.write(event->utime, event->channel, event->bytes);
      }
    }
    writer.flush();
  }
};

std::vector<json> lines_from(const Run& run) {
  std::vector<json> objects;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) objects.push_back(json::parse(line));
  return objects;
}

std::vector<std::string> inputs_of(const Run& run) {
  INFO(run.err);
  CHECK(run.code == 0);
  std::vector<std::string> names;
  for (const json& object : lines_from(run)) names.push_back(object["input"]);
  return names;
}

using Names = std::vector<std::string>;
const std::string kPlan = "plan --gripper franka --json - ";
const std::string kDetect = "detect --json - ";

}  // namespace

TEST_CASE("plan takes several inputs and all clouds of a log, an object a line", "[command][log]") {
  const TwoClouds two;
  CHECK(inputs_of(run_quadrille(kPlan + two.small + " " + two.log + " " + two.large)) ==
        Names{two.small, two.log + "#1", two.log + "#2", two.large});
  const Run one_missing = run_quadrille(kPlan + two.folder.path("none.ply") + " " + two.large);
  CHECK(one_missing.code == 1);
  REQUIRE(lines_from(one_missing).size() == 1);
  CHECK(contains(one_missing.err, "none.ply: no such file"));
  CHECK(contains(one_missing.err, "1 of 2 inputs could not be read"));
}

TEST_CASE("several plans are drawn into a picture each", "[command][picture]") {
  const TwoClouds two;
  const std::string picture = two.folder.path("p.png");
  REQUIRE(run_quadrille(kPlan + two.small + " " + two.large + " --picture " + picture).code == 0);
  CHECK(std::filesystem::exists(two.folder.path("p_small.png")));
  CHECK(std::filesystem::exists(two.folder.path("p_large.png")));
  CHECK_FALSE(std::filesystem::exists(picture));
}

TEST_CASE("of several views each is a picture of its own", "[command][picture]") {
  const TwoClouds two;
  const std::string picture = two.folder.path("p.svg");
  REQUIRE(
      run_quadrille(kDetect + two.small + " --picture-view top,side --picture " + picture).code ==
      0);
  CHECK(std::filesystem::exists(two.folder.path("p_top.svg")));
  CHECK(std::filesystem::exists(two.folder.path("p_side.svg")));
  CHECK_FALSE(std::filesystem::exists(picture));
  REQUIRE(run_quadrille(kDetect + two.small + " --picture-view top --picture " + picture).code ==
          0);
  CHECK(std::filesystem::exists(picture));
}

TEST_CASE("a cloud of a log is named by its number, from 1 on", "[command][log]") {
  const TwoClouds two;
  for (const std::string& command : {kDetect, kPlan}) {
    INFO(command);
    CHECK(inputs_of(run_quadrille(command + two.log + "#2")) == Names{two.log + "#2"});
    check_failure(run_quadrille(command + two.log + "#3"),
                  "both.lcm: there is no cloud #3; it holds 2 clouds");
    for (const char* none : {"#0", "#-1", "#x", "#", "#1.5", "#99999999999"}) {
      INFO(none);
      check_failure(run_quadrille(command + "'" + two.log + none + "'"),
                    "is no number of a cloud; they count from #1");
    }
    CHECK(contains(run_quadrille(command + "--help").out, "clouds.lcm#2 is the second cloud"));
  }
  CHECK(lines_from(run_quadrille(kDetect + two.log + "#2")).at(0)["points"]["read"] == 2);
  // A file of that name goes before.
  const std::string file = two.folder.write("both.lcm#1", test::ply_of({"1 2 3"}));
  check_failure(run_quadrille(kDetect + file), file);
}

TEST_CASE("a log of several channels is told, in JSON too, and --channel chooses one",
          "[command][log]") {
  const TwoClouds two;
  const std::string sentence =
      "holds clouds of several channels, LEFT (2), RIGHT (1); choose one with --channel";
  for (const std::string& command : {kDetect, kPlan}) {
    INFO(command);
    const Run all = run_quadrille(command + two.mixed);
    CHECK(inputs_of(all).size() == 3);
    CHECK(contains(all.err, "mixed.lcm: warning: " + sentence));
    const json warnings = lines_from(all).at(2)["warnings"];
    CHECK(std::find(warnings.begin(), warnings.end(), sentence) != warnings.end());
    const Run right = run_quadrille(command + "--channel RIGHT " + two.mixed);
    CHECK(inputs_of(right) == Names{two.mixed + "#1"});
    CHECK_FALSE(contains(right.err, "several channels"));
    const Run none = run_quadrille(command + "--channel FRONT " + two.mixed);
    CHECK(inputs_of(none).empty());
    CHECK(contains(none.err, "holds no cloud on FRONT, but events on LEFT (2), RIGHT (1)"));
    CHECK(run_quadrille(command + "--channel RIGHT " + two.small).code == 2);
  }
  CHECK(lines_from(run_quadrille(kDetect + two.mixed + "#3")).at(0)["points"]["read"] == 2);
  CHECK(lines_from(run_quadrille(kDetect + "--channel RIGHT " + two.mixed + "#1"))
            .at(0)["points"]["read"] == 2);
  check_failure(run_quadrille(kDetect + "--channel RIGHT " + two.mixed + "#2"),
                "there is no cloud #2; it holds 1 cloud on RIGHT");
}

TEST_CASE("a map and views are for a single cloud", "[command][log]") {
  const TwoClouds two;
  const std::string map = " --map " + two.folder.path("m.bt");
  const Run both = run_quadrille(kPlan + two.small + " " + two.large + map);
  CHECK(both.code == 2);
  CHECK(contains(both.err, "--map: takes a single INPUT"));
  CHECK(run_quadrille(kPlan + two.small + " " + two.large + " --view " + two.log).code == 2);
  check_failure(run_quadrille(kPlan + two.log + map), "such as " + two.log + "#1");
  check_failure(run_quadrille(kPlan + two.mixed + "#3 --view " + two.mixed), "more than one cloud");
  CHECK(inputs_of(run_quadrille(kPlan + two.log + "#2 --view " + two.log + "#1" + map)).size() ==
        1);
  check_failure(run_quadrille(kPlan + two.log + "#1 --view " + two.log + "#1"), "given twice");
  CHECK(inputs_of(run_quadrille(kPlan + "--channel RIGHT " + two.mixed + map)).size() == 1);
}
