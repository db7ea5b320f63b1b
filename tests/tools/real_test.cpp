#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "support/catch.hpp"
#include "support/data.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::Run;
using test::run_quadrille;

namespace {

json detect(const std::filesystem::path& scan) {
  const Run run = run_quadrille("detect --json - '" + scan.string() + "'");
  INFO(scan << " " << run.err);
  REQUIRE(run.code == 0);
  return json::parse(run.out);
}

bool is_cylinder_of(const json& detection, double radius, double tolerance) {
  return detection["type"] == "cylinder" &&
         std::abs(detection["dimensions"]["radius"].get<double>() - radius) <= tolerance;
}

bool is_sphere_of(const json& detection, double radius, double tolerance) {
  return detection["type"] == "sphere" &&
         std::abs(detection["dimensions"]["radius"].get<double>() - radius) <= tolerance;
}

/// True if a detection is of a type that an annotated object may have and holds most of its points.
bool covers(const json& detection, const json& object) {
  const json& types = object["accept_types"];
  return std::find(types.begin(), types.end(), detection["type"]) != types.end() &&
         2 * detection["inliers"].get<int>() >= object["n_inliers"].get<int>();
}

json scene_named(const json& manifest, const std::string& name) {
  for (const json& scene : manifest["scenes"]) {
    if (scene["name"] == name) return scene;
  }
  FAIL("no scene " << name << " in the manifest");
  return {};
}

}  // namespace

TEST_CASE("real scans are read whole and give no number that is not finite", "[command][real]") {
  const auto data = test::data_folder();
  if (!data) return;
  const json manifest = json::parse(test::content_of((*data / "data/real/manifest.json").string()));
  int read = 0;
  for (const json& scan : manifest["scenes"]) {
    if (!scan.contains("n_points")) continue;
    const std::string file = scan["file"];
    INFO(file);
    const json result = detect(*data / "data/real" / file);
    CHECK(result["points"]["read"] == scan["n_points"]);
    CHECK(result["points"]["finite"] > 0);
    CHECK_FALSE(result["detections"].empty());
    CHECK(result["detections"].dump().find("null") == std::string::npos);
    ++read;
  }
  CHECK(read >= 10);
}

TEST_CASE("the ball of a real sequence is found in each frame, mostly with its radius",
          "[command][real]") {
  const auto data = test::data_folder();
  if (!data) return;
  const json manifest = json::parse(test::content_of((*data / "data/real/manifest.json").string()));
  const json frames = scene_named(manifest, "d11_seq_ball_cam3")["frames"];
  int right = 0;
  for (const json& frame : frames) {
    const std::string file = frame["file"];
    const json& ball = frame["objects"][0];
    const json detections = detect(*data / "data/real" / file)["detections"];
    INFO(file << " " << detections.dump(1));
    CHECK(std::any_of(detections.begin(), detections.end(),
                      [&](const json& d) { return covers(d, ball); }));
    const double radius = ball["params"]["radius"];
    right += std::any_of(detections.begin(), detections.end(),
                         [&](const json& d) { return is_sphere_of(d, radius, 0.1 * radius); });
  }
  REQUIRE(frames.size() >= 10);
  // From one side, a noisy ball can also be told as an ellipsoid.
  CHECK(3 * right >= 2 * static_cast<int>(frames.size()));
}

TEST_CASE("the ball of a real sequence has one track in all frames", "[command][real][track]") {
  const auto data = test::data_folder();
  if (!data) return;
  const json manifest = json::parse(test::content_of((*data / "data/real/manifest.json").string()));
  const json frames = scene_named(manifest, "d11_seq_ball_cam3")["frames"];
  std::string files;
  for (const json& frame : frames) {
    files += " '" + (*data / "data/real" / frame["file"].get<std::string>()).string() + "'";
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
      if (!covers(d, frame["objects"][0])) continue;
      tracks.insert(d["track"].get<int>());
      ++found;
    }
  }
  CHECK(found == frames.size());
  CHECK(tracks.size() == 1);
}

TEST_CASE("boxes alone give nothing curved", "[command][real]") {
  const auto data = test::data_folder();
  if (!data) return;
  const json result = detect(*data / "data/real/d10_negative_boxes.ply");
  int planes = 0;
  for (const json& d : result["detections"]) {
    planes += d["type"] == "plane";
    INFO(d.dump(1));
    CHECK(d["type"] == "plane");
  }
  CHECK(planes >= 3);
}

TEST_CASE("the tall tin of the real scans is a cylinder of its radius", "[command][real]") {
  const auto data = test::data_folder();
  if (!data) return;
  const json result = detect(*data / "data/real/d04_tin_tall.ply");
  INFO(result["detections"].dump(1));
  const auto is_tin = [](const json& d) { return is_cylinder_of(d, 0.0345, 0.003); };
  const json& detections = result["detections"];
  CHECK(std::any_of(detections.begin(), detections.end(), is_tin));
}
