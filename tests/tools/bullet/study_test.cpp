#include <nlohmann/json.hpp>
#include <sstream>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::contains;
using test::run_quadrille;
using test::TempFolder;

TEST_CASE("a study holds what quadrille try holds", "[study][command]") {
  const TempFolder folder;
  const std::string scene = folder.path("s.ply"), csv = folder.path("a.csv");
  REQUIRE(run_quadrille("scene --family medium --seed 1 " + scene).code == 0);
  const json tried =
      json::parse(run_quadrille("try --first --gripper franka --json - " + scene).out);
  const auto run = run_quadrille(
      "study grasps --scenes 1 --family medium --seed 1 --gripper franka --csv " + csv);
  INFO(run.err);
  REQUIRE(run.code == 0);
  std::istringstream lines(test::content_of(csv));
  std::vector<std::string> outcomes;
  for (std::string line; std::getline(lines, line);) {
    // The last three cells are outcome, slip and rotation, empty if a grasp was not tried.
    if (line.ends_with(",,,") || line.starts_with("version")) continue;
    const std::size_t slip = line.rfind(',', line.rfind(',') - 1);
    const std::size_t outcome = line.rfind(',', slip - 1) + 1;
    outcomes.push_back(line.substr(outcome, slip - outcome));
  }
  REQUIRE(outcomes.size() == tried["grasps"].size());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    CHECK(outcomes[i] == tried["grasps"][i]["outcome"].get<std::string>());
  }
  const json& first = tried["summary"]["first"];
  CHECK(contains(run.out, "first grasps held"));
  CHECK(contains(test::content_of(folder.path("a.scenes.csv")),
                 "," + std::to_string(first["tried"].get<int>()) + "," +
                     std::to_string(first["held"].get<int>()) + ","));
}
