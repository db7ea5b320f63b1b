#include <cmath>
#include <nlohmann/json.hpp>

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

TEST_CASE("each frame of a real sequence is read and detected in", "[command][real]") {
  const auto data = test::data_folder();
  if (!data) return;
  int read = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(*data / "data/real/d11_seq_ball_cam3")) {
    if (entry.path().extension() != ".ply") continue;
    CHECK(detect(entry.path())["points"]["finite"] > 0);
    ++read;
  }
  CHECK(read >= 10);
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
