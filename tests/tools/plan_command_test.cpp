#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "io/ply/ply.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::check_failure;
using test::contains;
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
  const Run detected = run_quadrille("detect " + scene + " --json - --view " + copy);
  const json points = json::parse(detected.out).at("points");
  CHECK(points.at("read") == points.at("finite"));
  check_failure(run_quadrille(plan + " --view " + folder.path("none.ply")), "none.ply");
  CHECK_FALSE(contains(twice.err, "in frame"));
  std::string text = test::content_of(copy);
  const std::size_t at = text.find("comment frame ");
  REQUIRE(at != std::string::npos);
  text.replace(at, text.find('\n', at) - at, "comment frame base");
  const Run other = run_quadrille(plan + " --json - --view " + folder.write("base.ply", text));
  CHECK(contains(other.err, "base.ply: warning: is in frame 'base', and the input in 'camera'"));
  CHECK(contains(json::parse(other.out).at("warnings").dump(), "base.ply: is in frame 'base'"));
  check_failure(run_quadrille(plan + " --view " + scene), "given twice");
  check_failure(run_quadrille(plan + " --view " + copy + " --view " + copy), "given twice");
  check_failure(run_quadrille(plan + " --map " + folder.path("no/m.bt")), "m.bt");
  CHECK(run_quadrille(plan + " --map -").code == 2);
}

TEST_CASE("if only planes are found, smaller cells are named, and tried if advice is asked for",
          "[command]") {
  // Balls of 9 mm on a table, in pixels of a millimetre: too few of the usual cells lie on them.
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.25, 0.43});
  std::vector<test::Patch> patches = {test::rectangle(X_CW, 0.5, 0.5)};
  for (const double x : {-0.06, 0.0, 0.06}) {
    patches.push_back(test::sphere(X_CW * test::translation(x, 0.0, 0.009), 0.009));
  }
  const test::Camera camera{400, 300, 1.0 / 600.0, 0.001};
  const TempFolder folder;
  const auto plan = [&](const std::string& name, const std::string& options) {
    return run_quadrille("plan --gripper franka " + folder.path(name) + options);
  };
  io::write_ply(folder.path("balls.ply"), test::render(patches, camera));
  const Run alone = plan("balls.ply", "");
  INFO(alone.out << alone.err);
  CHECK(contains(alone.out,
                 "  only planes were found; --advise tries a smaller sampling.cell, which shows "
                 "smaller things (see detector/TUNING.md)\n"));
  const Run advised = plan("balls.ply", " --advise --json " + folder.path("a.json"));
  CHECK(contains(advised.out,
                 "  only planes were found, but sampling.cell = 0.002 (in --config "
                 "FILE) gives "));
  const json remedy = json::parse(test::content_of(folder.path("a.json")))["remedies"][0];
  CHECK(remedy["target"] == 0);
  // It is what the setting gives.
  const std::string fine = folder.write("fine.toml", "sampling.cell = 0.002\n");
  const Run with = plan("balls.ply", " --json - --config " + fine);
  const json grasps = json::parse(with.out)["grasps"];
  REQUIRE_FALSE(grasps.empty());
  CHECK(remedy["grasps"] == grasps.size());
  CHECK(remedy["score"] == grasps[0]["score"]);
  // Where there is nothing, it does not help, and is not advised.
  patches.resize(1);
  io::write_ply(folder.path("table.ply"), test::render(patches, camera));
  const Run empty = plan("table.ply", " --advise");
  CHECK(contains(empty.out, "and a smaller sampling.cell gives no grasp; see detector/TUNING.md"));
}
