#include "lab/scoring/frame.hpp"

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>

#include "lab/scene/scene_files.hpp"
#include "lcmtypes/contains.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::scoring {
namespace {

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

TEST_CASE("surfaces know their body, and are bodies of their own if the truth has none",
          "[scoring][frame]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  const scene::Scene scene = scene::make_scene({scene::Family::kMedium, 1000});
  write_scene(cloud, scene, true);
  std::set<int> bodies;
  for (const TrueSurface& surface : read_frame(cloud).surfaces) bodies.insert(surface.body);
  CHECK(bodies.size() == scene.layout.bodies.size());
  nlohmann::ordered_json truth = scene::truth_json(scene);
  for (auto& object : truth["objects"]) object.erase("body");
  folder.write("a.truth.json", truth.dump());
  const Frame frame = read_frame(cloud);
  bodies.clear();
  for (const TrueSurface& surface : frame.surfaces) bodies.insert(surface.body);
  CHECK(bodies.size() == frame.surfaces.size());
}

TEST_CASE("a frame of a sensor is read with the truth that other tools write", "[scoring][frame]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  const scene::Scene scene = scene::make_scene({scene::Family::kEasy, 1000});
  write_scene(cloud, scene, true);
  std::filesystem::remove(scene::truth_path(cloud));
  CHECK_THROWS_WITH(read_frame(cloud), test::contains("a.truth.json: no such file"));
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
  CHECK_THROWS_WITH(read_frame(cloud), test::contains("a.json: no truth of a scene"));
}

}  // namespace
}  // namespace quadrille::scoring
