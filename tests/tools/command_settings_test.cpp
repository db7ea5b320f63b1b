#include <cmath>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::check_failure;
using test::contains;
using test::lines_of;
using test::ply_of;
using test::Run;
using test::run_quadrille;
using test::TempFolder;

TEST_CASE("plan takes the planner's settings from the same file as the detector's", "[command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", ply_of({"1 2 3"}));
  const std::string plan = "plan --gripper franka " + cloud + " --config ";
  CHECK(
      run_quadrille(plan + folder.write("c.toml", "seed = 2\n[planner]\napproach = 0.1\n")).code ==
      0);
  check_failure(run_quadrille(plan + folder.write("d.toml", "[planner]\napproach = 9\n")),
                "planner.approach = 9: must lie between 0 and 1 m");
}

TEST_CASE("config prints the settings of a file, which reads back to the same", "[command]") {
  const TempFolder folder;
  const Run defaults = run_quadrille("config --defaults");
  CHECK(defaults.code == 0);
  CHECK(run_quadrille("config").out == defaults.out);
  CHECK(contains(defaults.out, "\n[planner]\n"));
  CHECK(contains(defaults.out, "\n[track]\n"));
  const std::string file =
      folder.write("c.toml", "seed = 9\n[planes]\nleast_samples = 50\n[planner]\nbaseline = 0\n");
  const Run mine = run_quadrille("config --config " + file);
  CHECK(mine.code == 0);
  CHECK(contains(mine.out, "\nseed = 9\n"));
  CHECK(contains(mine.out, "\nmin_samples = 50\n"));
  CHECK(contains(mine.out, "\nbaseline = 0.0\n"));
  CHECK(run_quadrille("config --config " + folder.write("d.toml", mine.out)).out == mine.out);
  CHECK(run_quadrille("config --defaults --config " + file).code == 2);
  check_failure(run_quadrille("config --config " + folder.path("none.toml")), "no such file");
}

TEST_CASE("a plan without grasps says why and what to try", "[command]") {
  const TempFolder folder;
  const Run none =
      run_quadrille("plan --gripper franka " + folder.write("a.ply", ply_of({"1 2 3"})));
  CHECK(
      contains(none.out,
               "no grasps found\n  nothing that could be grasped was found, or asked for; see the "
               "warnings"));
  CHECK(contains(none.err, "a.ply: warning: "));
  const std::string scene = folder.path("s.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 3 " + scene).code == 0);
  // This hand closes on nothing that is wider than a millimetre.
  const std::string tiny = folder.write(
      "tiny.toml",
      "max_opening = 0.001\nmin_opening = 0.0\nfinger = [0.02, 0.015, 0.05]\nfinger_front = "
      "0.01\npad = [0.02, 0.02]\npalm = [0.06, 0.2, 0.06]\nmax_force = 70\n");
  const Run narrow = run_quadrille("plan --gripper " + tiny + " " + scene);
  INFO(narrow.out << narrow.err);
  CHECK(contains(narrow.out, "wider than the gripper opens"));
  CHECK(contains(narrow.out, "\n  no grasp on 1: "));
  CHECK_FALSE(contains(narrow.out, "    --gripper franka: "));
  const Run advised = run_quadrille("plan --advise --target 1 --gripper " + tiny + " " + scene);
  INFO(advised.out << advised.err);
  CHECK(contains(advised.out, "    --gripper franka: "));
}

TEST_CASE("a plan gives the hand's pose in another convention beside the grasp's", "[command]") {
  const TempFolder folder;
  const std::string scene = folder.path("s.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 3 " + scene).code == 0);
  const std::string plan = "plan --json - --gripper ";
  const json without = json::parse(run_quadrille(plan + "franka " + scene).out);
  const json with = json::parse(run_quadrille(plan + "franka --convention moveit " + scene).out);
  REQUIRE_FALSE(with["grasps"].empty());
  CHECK_FALSE(without["grasps"][0].contains("X_CH"));
  const json& hand = with["grasps"][0]["X_CH"];
  CHECK(hand["convention"] == "moveit");
  // The same orientation, 103.4 mm behind.
  CHECK(hand["quaternion"] == with["grasps"][0]["X_CG"]["quaternion"]);
  CHECK(with["grasps"][0]["X_CG"] == without["grasps"][0]["X_CG"]);
  double square = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double p = hand["position"][i], q = with["grasps"][0]["X_CG"]["position"][i];
    square += (p - q) * (p - q);
  }
  CHECK(std::sqrt(square) == Approx(0.1034));
  CHECK(run_quadrille(plan + "franka --convention claw " + scene).code == 2);
}

TEST_CASE("a wrong configuration or gripper file ends the command with 1", "[command][hostile]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", ply_of({"1 2 3"}));
  const std::string wrong = folder.write("c.toml", "seed = 1\nnonsense = 2\n");
  check_failure(run_quadrille("detect --config " + wrong + " " + cloud), "line 2");
  check_failure(run_quadrille("plan --gripper " + wrong + " " + cloud), "max_opening");
}
