#include "view/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/describe.hpp"
#include "io/json/json.hpp"
#include "io/json/json_parts.hpp"
#include "io/json/shapes_file.hpp"
#include "io/planner/advice.hpp"
#include "io/planner/plan_json.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/setting.hpp"
#include "quadrille/grasping/refusal.hpp"
#include "view/scene/owners.hpp"
#include "view/scene/pack.hpp"

namespace quadrille::view {
namespace {

using io::Json;

/// Formats "41.0 ± 0.2 mm"; without a finite deviation the value is marked as a guess.
std::string measure_text(double value, double std, const char* unit) {
  if (!std::isfinite(std)) return fmt::format("{:.1f} {} (a guess)", value, unit);
  return fmt::format("{:.1f} ± {:.1f} {}", value, std, unit);
}

/// Returns "radius 41.0 ± 0.2 mm" for each dimension.
Json lines_of(const Detection& detection) {
  constexpr double kDegrees = 180.0 / std::numbers::pi, kMillimetres = 1000.0;
  Json lines = Json::array();
  for (const Dimension& d : detection.dimensions) {
    const double scale = is_angle(d.name) ? kDegrees : kMillimetres;
    std::string name = d.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    lines.push_back(
        fmt::format("{} {}", name,
                    measure_text(scale * d.value, scale * d.std, is_angle(d.name) ? "°" : "mm")));
  }
  return lines;
}

Json lines_of(const Box& box) {
  Json lines = Json::array();
  for (int i = 0; i < 3; ++i) {
    lines.push_back(fmt::format("side {}{}",
                                measure_text(1000.0 * box.size[i], 1000.0 * box.std[i], "mm"),
                                box.seen[static_cast<std::size_t>(i)] ? "" : " (not seen)"));
  }
  return lines;
}

/// Lists the refusals, each with advice. The reasons of the last checks come first, since they
/// refused the candidates that got furthest.
Json refusals_of(const Rejected& rejected, UnknownPolicy unknown) {
  Json list = Json::array();
  for (int n = static_cast<int>(Refusal::kDeadline); n >= 0; --n) {
    const auto found = rejected.find(std::string(to_string(static_cast<Refusal>(n))));
    if (found == rejected.end()) continue;
    const auto& [reason, count] = *found;
    list.push_back({{"reason", reason}, {"count", count}, {"help", advise(reason, unknown)}});
  }
  return list;
}

/// Returns the outline of a plane's points if there are enough, otherwise the clipped surface.
Mesh mesh_of_object(const Detection& d, std::size_t place,
                    const std::vector<Eigen::Vector3f>& points,
                    const std::vector<std::uint8_t>& owners) {
  if (d.type != QuadricType::kPlane) return mesh_of(d);
  const Eigen::Isometry3d X_QC = d.X_CQ.inverse();
  std::vector<Eigen::Vector2d> flat;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (owners[i] != place + 1) continue;
    flat.push_back((X_QC * points[i].cast<double>()).head<2>());
  }
  Mesh mesh = mesh_of_outline(std::move(flat));
  return mesh.triangles.empty() ? mesh_of(d, 2) : mesh;
}

Json gripper_of(const Gripper& g) {
  return {{"finger", io::array_of(g.finger)},
          {"finger_front", g.finger_front},
          {"pad", io::array_of(g.pad)},
          {"palm", io::array_of(g.palm)},
          {"max_opening", g.max_opening}};
}

Json grasps_of(const Scene& scene, std::size_t max_grasps) {
  Json list = Json::array();
  for (const Grasp& grasp : scene.grasps) {
    if (list.size() == max_grasps) break;
    Json json = io::to_json(grasp);
    if (list.size() < scene.outcomes.size()) json["outcome"] = scene.outcomes[list.size()];
    // Distances from the palm's front to the pads, closed and opened, since the tips of linked
    // fingers draw back.
    if (scene.gripper) {
      json["reach"] = scene.gripper->reach(grasp.width);
      json["open_reach"] = scene.gripper->reach(grasp.preshape);
    }
    list.push_back(json);
  }
  return list;
}

/// Concatenates triples of numbers.
template <class Number>
std::vector<Number> flattened(const std::vector<std::array<Number, 3>>& triples) {
  std::vector<Number> numbers;
  for (const auto& triple : triples) numbers.insert(numbers.end(), triple.begin(), triple.end());
  return numbers;
}

Json voxels_of(const VoxelLayers& layers, Arrays* arrays) {
  return {{"edge", layers.edge},
          {"corner", io::array_of(layers.corner)},
          {"occupied", arrays->add(flattened(layers.occupied))},
          {"unknown", arrays->add(flattened(layers.unknown))}};
}

Json shapes_of(const std::vector<SolidShape>& shapes) {
  Json list = Json::array();
  for (const SolidShape& shape : shapes) list.push_back(io::to_json(shape));
  return list;
}

/// Adds the fields that quadrics, boxes and lumps have in common.
void add_common(const Scene& scene, int id, Json* object) {
  const auto found = scene.rejected_of.find(id);
  if (found != scene.rejected_of.end()) {
    (*object)["rejected"] = refusals_of(found->second, scene.unknown);
  }
  if (const auto sighting = scene.sightings.find(id); sighting != scene.sightings.end()) {
    // Plans tell of all parts of a body under the id of the body.
    if (sighting->second.body != id) (*object)["part_of"] = sighting->second.body;
    (*object)["views"] = sighting->second.views;
    (*object)["unseen"] = sighting->second.unseen;
    if (const auto& wall = sighting->second.wall) {
      (*object)["lines"].push_back(io::describe_wall(*wall));
    }
    // A quadric has a track of its own.
    const int track = sighting->second.track;
    if (track > 0 && (*object)["kind"] != "quadric") (*object)["track"] = track;
  }
}

Json objects_of(const Scene& scene, const PackLimits& limits, Arrays* arrays, Json* points) {
  std::vector<Detection> detections = scene.detections;
  if (detections.size() > limits.objects) detections.resize(limits.objects);
  std::vector<Rgb> colours;
  const std::vector<Eigen::Vector3f> shown = thin_out(scene.cloud, limits.points, &colours);
  const std::vector<std::uint8_t> owners = owners_of(shown, detections);
  *points = arrays->add_positions(shown);
  (*points)["owners"] = arrays->add(owners);
  if (!colours.empty()) (*points)["colours"] = arrays->add(flattened(colours));
  (*points)["total"] = scene.cloud.read;
  Json objects = Json::array();
  for (std::size_t i = 0; i < detections.size(); ++i) {
    Json object = io::to_json(detections[i]);
    object["kind"] = "quadric";
    object["lines"] = lines_of(detections[i]);
    object["mesh"] = arrays->add_mesh(mesh_of_object(detections[i], i, shown, owners));
    add_common(scene, detections[i].id, &object);
    objects.push_back(object);
  }
  for (const Box& box : scene.boxes) {
    if (objects.size() >= limits.objects) break;
    Json object = io::to_json(box);
    object["kind"] = "box";
    object["type"] = "box";
    object["lines"] = lines_of(box);
    add_common(scene, box.id, &object);
    objects.push_back(object);
  }
  for (const SceneBody& lump : scene.lumps) {
    if (objects.size() >= limits.objects) break;
    Json object = io::to_json(lump);
    object["type"] = "lump";
    object["lines"] = {io::describe_lump(lump), fmt::format("points {}", lump.points)};
    add_common(scene, lump.id, &object);
    objects.push_back(object);
  }
  return objects;
}

}  // namespace

std::vector<SceneBody> lumps_of(const std::vector<SceneBody>& bodies) {
  std::vector<SceneBody> lumps;
  std::copy_if(bodies.begin(), bodies.end(), std::back_inserter(lumps),
               [](const SceneBody& body) { return body.kind == BodyKind::kLump; });
  return lumps;
}

std::map<int, Sighting> sightings_of(const std::vector<SceneBody>& bodies) {
  std::map<int, Sighting> sightings;
  for (const SceneBody& body : bodies) {
    const Sighting sighting{body.id, body.views, body.unseen, body.track, body.wall};
    sightings[body.id] = sighting;
    for (const int part : body.parts) sightings[part] = sighting;
  }
  return sightings;
}

Json plan_json(const Scene& scene, const PackLimits& limits) {
  return {{"grasps", grasps_of(scene, limits.grasps)},
          {"rejected", refusals_of(scene.rejected, scene.unknown)},
          {"remedies", io::to_json(scene.remedies)},
          {"looks", io::to_json(scene.looks)},
          {"gripper_name", scene.gripper_name},
          {"gripper", scene.gripper ? gripper_of(*scene.gripper) : Json(nullptr)},
          {"unknown", to_string(scene.unknown)},
          {"warnings", scene.warnings}};
}

std::string pack_scene(const Scene& scene, const PackLimits& limits) {
  Arrays arrays;
  Json json = {{"name", scene.name},
               {"frame", scene.cloud.frame},
               {"utime", scene.utime},
               {"seq", scene.seq},
               {"viewpoint", io::array_of(scene.cloud.viewpoint)}};
  Json points;
  json["objects"] = objects_of(scene, limits, &arrays, &points);
  json["points"] = points;
  json.update(plan_json(scene, limits));
  json["voxels"] = voxels_of(scene.voxels, &arrays);
  json["robot"] = shapes_of(scene.robot);
  json["obstacles"] = shapes_of(scene.obstacles);
  json["camera"] = {{"pose", scene.X_CK ? io::to_json(*scene.X_CK) : Json(nullptr)},
                    {"path", arrays.add_positions(scene.path)}};
  Json timings = Json::object();
  io::add_stages(scene.timings, &timings);
  json["timings"] = timings;
  json["notes"] = scene.notes;
  return join_pack(json, arrays);
}

}  // namespace quadrille::view
