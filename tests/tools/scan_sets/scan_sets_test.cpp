// On sets of real scans that are no part of the source; see tests/CMakeLists.txt.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "lab/experiments/experiment.hpp"
#include "support/catch.hpp"
#include "support/environment_variable.hpp"
#include "tools/detections.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::Run;
using test::run_quadrille;

namespace {

std::filesystem::path scan_set() {
  return std::filesystem::path(QUADRILLE_DATA_FOLDER) / "data" / "real";
}

/// The entry of a manifest with that name.
json scene_named(const json& manifest, const std::string& name) {
  for (const json& scene : manifest["scenes"]) {
    if (scene["name"] == name) return scene;
  }
  FAIL("no scene " << name << " in the manifest");
  return {};
}

}  // namespace

TEST_CASE("all scans of the set are read whole and give no number that is not finite",
          "[command][real]") {
  const json manifest = test::manifest_of(scan_set());
  int read = 0;
  for (const json& scan : manifest["scenes"]) {
    if (!scan.contains("n_points")) continue;
    test::check_read_whole(scan_set(), scan);
    ++read;
  }
  CHECK(read >= 10);
}

TEST_CASE("the ball of a real sequence is found in each frame, mostly with its radius",
          "[command][real]") {
  const json manifest = test::manifest_of(scan_set());
  const json frames = scene_named(manifest, "d11_seq_ball_cam3")["frames"];
  int right = 0;
  for (const json& frame : frames) {
    const std::string file = frame["file"];
    const json& ball = frame["objects"][0];
    const json detections = test::detect(scan_set() / file)["detections"];
    INFO(file << " " << detections.dump(1));
    CHECK(std::any_of(detections.begin(), detections.end(),
                      [&](const json& d) { return test::covers(d, ball); }));
    const double radius = ball["params"]["radius"];
    right += std::any_of(detections.begin(), detections.end(), [&](const json& d) {
      return test::is_sphere_of(d, radius, 0.1 * radius);
    });
  }
  REQUIRE(frames.size() >= 10);
  // From one side, a noisy ball can also be told as an ellipsoid.
  CHECK(3 * right >= 2 * static_cast<int>(frames.size()));
}

TEST_CASE("the ball of a real sequence has one track in all frames", "[command][real][track]") {
  const json manifest = test::manifest_of(scan_set());
  const json frames = scene_named(manifest, "d11_seq_ball_cam3")["frames"];
  std::string files;
  for (const json& frame : frames) {
    files += " '" + (scan_set() / frame["file"].get<std::string>()).string() + "'";
  }
  const Run run = run_quadrille("detect --track --json -" + files);
  INFO(run.err);
  REQUIRE(run.code == 0);
  std::istringstream lines(run.out);
  std::set<int> tracks;
  std::size_t found = 0;
  for (const json& frame : frames) {
    std::string line;
    REQUIRE(std::getline(lines, line));
    const json result = json::parse(line);
    for (const json& d : result["detections"]) {
      if (!test::covers(d, frame["objects"][0])) continue;
      tracks.insert(d["track"].get<int>());
      ++found;
    }
  }
  CHECK(found == frames.size());
  CHECK(tracks.size() == 1);
}

TEST_CASE("scans without anything round give planes, and at most one curved surface in all",
          "[command][real]") {
  int scans = 0, curved = 0;
  for (const std::string set : {"real", "real2"}) {
    const auto folder = scan_set().parent_path() / set;
    if (!std::filesystem::exists(folder)) continue;
    const json manifest = test::manifest_of(folder);
    for (const json& scan : manifest["scenes"]) {
      if (!scan.contains("objects")) continue;  // a sequence
      const json& objects = scan["objects"];
      const bool boxes = std::all_of(objects.begin(), objects.end(),
                                     [](const json& object) { return object["type"] == "plane"; });
      if (!boxes) continue;
      ++scans;
      const json result = test::detect(folder / scan["file"].get<std::string>());
      int planes = 0;
      for (const json& d : result["detections"]) planes += d["type"] == "plane";
      CHECK(planes >= 2);
      curved += static_cast<int>(result["detections"].size()) - planes;
    }
  }
  CHECK(scans >= 1);
  CHECK(curved <= 1);
}

TEST_CASE("the tall tin of the real scans is a cylinder of its radius", "[command][real]") {
  const json result = test::detect(scan_set() / "d04_tin_tall.ply");
  INFO(result["detections"].dump(1));
  const auto is_tin = [](const json& d) { return test::is_cylinder_of(d, 0.0345, 0.003); };
  const json& detections = result["detections"];
  CHECK(std::any_of(detections.begin(), detections.end(), is_tin));
}

TEST_CASE("the ball of the real sequence is measured to a few per cent", "[experiment][real]") {
  const test::EnvironmentVariable there("QUADRILLE_DATA", QUADRILLE_DATA_FOLDER);
  experiments::Settings settings;
  settings.quick = true;
  const experiments::Report report = experiments::find_experiment("sequence")->run(settings);
  REQUIRE(report.data.rows.size() == 3);
  for (const auto& row : report.data.rows) {
    CHECK(row[1] == "1");
    CHECK(std::abs(std::stod(row[2])) < 0.1);
    CHECK(std::stod(row[3]) < 0.2);
  }
}
