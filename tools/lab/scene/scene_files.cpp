#include "lab/scene/scene_files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "base/quantile.hpp"
#include "io/json/json_parts.hpp"
#include "io/new_file.hpp"
#include "io/ply/ply.hpp"

namespace quadrille::scene {
namespace {

using Json = nlohmann::ordered_json;

using io::array_of;

Json pose_json(const Eigen::Isometry3d& X) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(array_of(Eigen::Vector3d(X.linear().row(i))));
  return {{"R", rows}, {"t", array_of(Eigen::Vector3d(X.translation()))}};
}

/// The measurements of one surface by the camera.
struct Seen {
  int points = 0;
  /// Median depth [m].
  double depth = 0.0;
  /// Angle around the mean normal that contains nine tenths of the normals [degrees].
  double normal_spread = 0.0;
};

Seen seen_of(const View& view, int index) {
  std::vector<float> depths, cosines;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    if (view.labels[i] != index) continue;
    depths.push_back(view.points[i].z());
    mean += view.normals[i];
  }
  if (depths.empty()) return {};
  mean.normalize();
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    if (view.labels[i] == index) cosines.push_back(mean.dot(view.normals[i]));
  }
  const double cosine = std::clamp(nth_smallest(cosines, cosines.size() / 10), -1.0f, 1.0f);
  return {static_cast<int>(depths.size()), median(depths),
          std::acos(cosine) * 180.0 / std::numbers::pi};
}

/// Returns true if enough of the surface is visible for a detector to find it.
bool is_fair(const Surface& surface, const Seen& seen, double occlusion, const Camera& camera) {
  const double resolution = static_cast<double>(camera.width) * camera.height / (640.0 * 480.0);
  const double least = (surface.curved ? 350.0 : 500.0) * resolution;
  return seen.points >= least && occlusion <= 0.85 &&
         (!surface.curved || seen.normal_spread >= 25.0);
}

Json object_json(const Scene& scene, std::size_t body_index, std::size_t part, int id) {
  const Body& body = scene.layout.bodies[body_index];
  const Surface& surface = body.surfaces[part];
  const Eigen::Isometry3d X_CS = scene.layout.X_CW * body.X_WB * body.X_BS[part];
  const Seen seen = seen_of(scene.view, id);
  const int alone = scene.ideal.alone[id], visible = scene.ideal.visible[id];
  const double occlusion = alone > 0 ? 1.0 - static_cast<double>(visible) / alone : 1.0;
  Json dims = Json::object();
  for (const auto& [name, value] : surface.dims) dims[name] = value;
  const Eigen::Vector3d size = surface.box_S.sizes();
  return {{"id", id},
          {"kind", surface.curved ? "quadric" : "plane"},
          {"type", surface.type},
          {"body", body_index},
          {"dims", dims},
          {"q", array_of(surface.Q_S.transformed(X_CS).normalized().coefficients())},
          {"pose", pose_json(X_CS)},
          {"box", {array_of(surface.box_S.min()), array_of(surface.box_S.max())}},
          {"size", size.maxCoeff()},
          {"pixels_alone", alone},
          {"pixels_visible", visible},
          {"occlusion", occlusion},
          {"points", seen.points},
          {"sigma", depth_noise(traits_of(scene.options.family).noise, seen.depth)},
          {"normal_spread", seen.normal_spread},
          {"evaluate", is_fair(surface, seen, occlusion, scene.camera)}};
}

std::string without_extension(const std::string& path) {
  return std::filesystem::path(path).replace_extension().string();
}

}  // namespace

Eigen::Vector3d vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Eigen::Isometry3d pose_of(const Json& json) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) X.linear().row(i) = vector_of(json.at("R").at(i)).transpose();
  X.translation() = vector_of(json.at("t"));
  return X;
}

Eigen::AlignedBox3d box_of(const Json& json) {
  return {vector_of(json.at(0)), vector_of(json.at(1))};
}

Quadric quadric_of(const Json& json) {
  Vector10d q;
  for (int i = 0; i < 10; ++i) q[i] = json.at(i).get<double>();
  return Quadric(q);
}

std::string truth_path(const std::string& path) { return without_extension(path) + ".truth.json"; }

std::optional<std::string> find_truth(const std::string& ply_path) {
  namespace fs = std::filesystem;
  if (const std::string path = truth_path(ply_path); fs::exists(path)) return path;
  const fs::path other = fs::path(ply_path).replace_extension(".json");
  return fs::exists(other) ? std::optional(other.string()) : std::nullopt;
}

Json truth_json(const Scene& scene) {
  const FamilyTraits& traits = traits_of(scene.options.family);
  Json objects = Json::array();
  int id = 0;
  for (std::size_t body = 0; body < scene.layout.bodies.size(); ++body) {
    for (std::size_t part = 0; part < scene.layout.bodies[body].surfaces.size(); ++part) {
      objects.push_back(object_json(scene, body, part, id++));
    }
  }
  return {{"family", traits.name},
          {"seed", scene.options.seed},
          {"width", scene.camera.width},
          {"height", scene.camera.height},
          {"focal", scene.camera.focal},
          {"cx", scene.camera.cx},
          {"cy", scene.camera.cy},
          {"noise_scale", traits.noise},
          {"noise_correlation", 0.0},
          {"noise_waves", kSmoothShare},
          {"points", scene.view.points.size()},
          {"labels", {{"flying", kMixed}, {"outlier", kStray}}},
          {"objects", objects}};
}

std::string truth_text(const Scene& scene) { return truth_json(scene).dump(1) + "\n"; }

void write_scene(const std::string& ply_path, const Scene& scene, bool labels) {
  PointCloud cloud;
  cloud.points = scene.view.points;
  cloud.frame = kCameraFrame;
  io::NewFile ply(ply_path), truth(truth_path(ply_path));
  ply.write(io::ply_of(cloud));
  truth.write(truth_text(scene));
  if (labels) {
    const std::string base = without_extension(ply_path);
    static_assert(sizeof(int) == 4 && sizeof(Eigen::Vector3f) == 12);
    io::write_file(base + ".labels", std::as_bytes(std::span(scene.view.labels)));
    io::write_file(base + ".normals", std::as_bytes(std::span(scene.view.normals)));
  }
  // The cloud appears last, so that its ground truth is there before it.
  truth.commit();
  ply.commit();
}

}  // namespace quadrille::scene
