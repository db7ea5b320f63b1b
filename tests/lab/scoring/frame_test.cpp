#include "lab/scoring/frame.hpp"

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "lab/scene/scene_files.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::scoring {
namespace {

/// What is wrong with a frame in files; empty if nothing is.
std::string error_of(const std::string& ply_path) {
  return test::error_of([&] { read_frame(ply_path); });
}

TEST_CASE("the points of a generated frame lie on the surfaces that they are labelled with",
          "[scoring][frame]") {
  const Frame frame = frame_of(scene::make_scene({scene::Family::kMedium, 1000}));
  CHECK(frame.name == "medium 1000");
  REQUIRE(frame.labels.size() == frame.cloud.points.size());
  REQUIRE(frame.normals.size() == frame.cloud.points.size());
  std::map<int, const TrueSurface*> surfaces;
  for (const TrueSurface& surface : frame.surfaces) surfaces[surface.id] = &surface;
  int on = 0, all = 0;
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    const Eigen::Vector3d x = frame.cloud.points[i].cast<double>();
    REQUIRE(x.allFinite());
    if (frame.labels[i] < 0) continue;
    REQUIRE(surfaces.count(frame.labels[i]) == 1);
    const TrueSurface& surface = *surfaces[frame.labels[i]];
    const double noise = scene::depth_noise(frame.noise, x.z());
    const Eigen::Vector3d g = surface.Q_C.gradient(x).normalized();
    ++all;
    on += std::abs(surface.Q_C.distance(x)) < 5.0 * noise &&
          std::abs(g.dot(frame.normals[i].cast<double>())) > 0.9 &&
          surface.box_S.exteriorDistance(surface.X_CS.inverse() * x) < 0.02;
  }
  CHECK(all > 100000);
  CHECK(on > 0.97 * all);
}

TEST_CASE("a frame of a sensor is read with the truth that other tools write", "[scoring][frame]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  const scene::Scene scene = scene::make_scene({scene::Family::kEasy, 1000});
  write_scene(cloud, scene, true);
  std::filesystem::remove(scene::truth_path(cloud));
  CHECK(error_of(cloud).find("a.truth.json: no such file") != std::string::npos);
  nlohmann::ordered_json truth = scene::truth_json(scene);
  truth["sensor"] = "stereo";
  folder.write("a.json", truth.dump());
  const Frame frame = read_frame(cloud);
  CHECK(frame.family == "stereo easy");
  CHECK(frame.surfaces.size() == frame_of(scene).surfaces.size());
}

TEST_CASE("the truth that we write counts before a file that is merely named as a cloud",
          "[scoring][frame]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  write_scene(cloud, scene::make_scene({scene::Family::kEasy, 1000}), true);
  folder.write("a.json", "{}");
  CHECK(read_frame(cloud).family == "easy");
  std::filesystem::remove(scene::truth_path(cloud));
  CHECK(error_of(cloud).find("a.json: no truth of a scene") != std::string::npos);
}

}  // namespace
}  // namespace quadrille::scoring
