#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::check_failure;
using test::Run;
using test::run_quadrille;
using test::TempFolder;

TEST_CASE("plan writes its map as OctoMap reads it, and fuses further views", "[command]") {
  const TempFolder folder;
  const std::string scene = folder.path("s.ply"), map = folder.path("s.bt");
  REQUIRE(run_quadrille("scene --family tabletop --seed 3 " + scene).code == 0);
  const std::string plan = "plan --gripper franka " + scene;
  const Run run = run_quadrille(plan + " --map " + map);
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(test::content_of(map).starts_with("# Octomap OcTree binary file\nid OcTree\n"));
  // A copy of the cloud already lies on it, so that its pose needs no correction. The same file
  // twice is refused.
  const std::string copy = folder.path("copy.ply");
  std::filesystem::copy_file(scene, copy);
  const Run twice = run_quadrille(plan + " --view " + copy + " --json -");
  REQUIRE(twice.code == 0);
  const json views = json::parse(twice.out).at("views");
  REQUIRE(views.size() == 1);
  CHECK(views[0].at("input") == copy);
  for (const double shift : views[0].at("correction").at("position")) CHECK(std::abs(shift) < 1e-6);
  check_failure(run_quadrille(plan + " --view " + folder.path("none.ply")), "none.ply");
  check_failure(run_quadrille(plan + " --view " + scene), "given twice");
  check_failure(run_quadrille(plan + " --view " + copy + " --view " + copy), "given twice");
  check_failure(run_quadrille(plan + " --map " + folder.path("no/m.bt")), "m.bt");
}
