#include "tools/detections.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

namespace quadrille::test {
namespace {

using nlohmann::json;

bool has_radius(const json& detection, const char* type, double radius, double tolerance) {
  return detection["type"] == type &&
         std::abs(detection["dimensions"]["radius"].get<double>() - radius) <= tolerance;
}

}  // namespace

json detect(const std::filesystem::path& scan) {
  const Run run = run_quadrille("detect --json - '" + scan.string() + "'");
  INFO(scan << " " << run.err);
  REQUIRE(run.code == 0);
  return json::parse(run.out);
}

json manifest_of(const std::filesystem::path& folder) {
  return json::parse(content_of((folder / "manifest.json").string()));
}

void check_read_whole(const std::filesystem::path& folder, const json& scan) {
  const std::string file = scan["file"];
  INFO(file);
  json result = detect(folder / file);
  CHECK(result["points"]["read"] == scan["n_points"]);
  CHECK(result["points"]["finite"] > 0);
  CHECK_FALSE(result["detections"].empty());
  // What is a guess has no deviation.
  for (json& detection : result["detections"]) detection.erase("std");
  CHECK(result["detections"].dump().find("null") == std::string::npos);
}

bool is_cylinder_of(const json& detection, double radius, double tolerance) {
  return has_radius(detection, "cylinder", radius, tolerance);
}

bool is_sphere_of(const json& detection, double radius, double tolerance) {
  return has_radius(detection, "sphere", radius, tolerance);
}

bool covers(const json& detection, const json& object) {
  const json& types = object["accept_types"];
  return std::find(types.begin(), types.end(), detection["type"]) != types.end() &&
         2 * detection["inliers"].get<int>() >= object["n_inliers"].get<int>();
}

}  // namespace quadrille::test
