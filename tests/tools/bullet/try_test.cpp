#include <cmath>
#include <nlohmann/json.hpp>

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

/// A scene of few targets, since each trial takes a second. The medium one has a target that is
/// held and one that turns in the Franka Hand; the easy one has two that are held.
std::string make_scene(const TempFolder& folder, const std::string& chosen) {
  const std::string scene = folder.path("s.ply");
  REQUIRE(run_quadrille("scene --family " + chosen + " " + scene).code == 0);
  return scene;
}

}  // namespace

TEST_CASE("grasps of a scene are tried, and the same ones from the plan's file", "[command]") {
  const TempFolder folder;
  const std::string scene = make_scene(folder, "medium --seed 1"), hand = " --gripper franka ",
                    tried = folder.path("t.json");
  const Run table = run_quadrille("try --first --json " + tried + hand + scene);
  INFO(table.out << table.err);
  REQUIRE(table.code == 0);
  CHECK(contains(table.out, "turn/deg"));
  CHECK(contains(table.out, "first of each target"));
  const json direct = json::parse(test::content_of(tried));
  REQUIRE_FALSE(direct["grasps"].empty());
  for (const json& grasp : direct["grasps"]) {
    CHECK(grasp["first"] == true);
    const bool held = grasp["lifted"] && grasp["slip"] < 0.005 && grasp["rotation"] < 0.08727;
    CHECK(grasp["held"] == held);
    CHECK((grasp["outcome"] == "held") == held);
  }
  const std::string plan = folder.path("p.json");
  REQUIRE(run_quadrille("plan --json " + plan + hand + scene).code == 0);
  const json again = json::parse(run_quadrille("try --first --json -" + hand + plan).out);
  REQUIRE(again["grasps"].size() == direct["grasps"].size());
  for (std::size_t i = 0; i < again["grasps"].size(); ++i) {
    // Poses come back from JSON to the last bit but one.
    CHECK(again["grasps"][i]["object"] == direct["grasps"][i]["object"]);
    CHECK(again["grasps"][i]["touched"] == direct["grasps"][i]["touched"]);
  }
  const json slippery =
      json::parse(run_quadrille("try --first --friction 0 --json -" + hand + plan).out);
  CHECK(slippery["summary"]["first"]["held"] == 0);
}

TEST_CASE("grasps are tried on plans of the true quadrics, whatever else cannot be tried",
          "[command][hostile]") {
  const TempFolder folder;
  const std::string scene = make_scene(folder, "easy --seed 4"), tried = folder.path("t.json"),
                    options = "try --exact --first --gripper wsg50 --json ";
  const Run run = run_quadrille(options + "- " + scene);
  REQUIRE(run.code == 0);
  const json exact = json::parse(run.out);
  REQUIRE(exact["summary"]["first"]["tried"] > 0);
  CHECK(exact["summary"]["first"]["held"] > 0);
  for (const json& grasp : exact["grasps"]) CHECK(grasp["object"] == grasp["target"]);
  const Run some = run_quadrille(options + tried + " " + folder.path("none.ply") + " " + scene);
  CHECK(some.code == 1);
  CHECK(contains(some.err, "none.truth.json"));
  CHECK(contains(some.err, "1 of 2 inputs could not be tried"));
  CHECK(contains(some.out, "first of each target"));
  CHECK(json::parse(test::content_of(tried))["grasps"] == exact["grasps"]);
}

TEST_CASE("what cannot be tried ends with one line, or as wrong usage", "[command][hostile]") {
  const TempFolder folder;
  const std::string hand = "try --gripper franka ";
  CHECK(run_quadrille("try " + folder.path("s.ply")).code == 2);
  CHECK(run_quadrille(hand + "a.pcd").code == 2);
  CHECK(run_quadrille(hand + "--friction -1 a.ply").code == 2);
  check_failure(run_quadrille(hand + folder.path("none.ply")), "none.truth.json");
  check_failure(run_quadrille(hand + folder.write("p.json", "{}")), "p.json");
  const std::string plan =
      R"({"input": ")" + folder.path("gone.ply") + R"(", "detections": [], "grasps": []})";
  check_failure(run_quadrille(hand + folder.write("q.json", plan)), "gone.truth.json");
}
