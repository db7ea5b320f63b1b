#include "lab/scoring/frame.hpp"

#include <array>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/cloud_file.hpp"
#include "io/file_bytes.hpp"
#include "io/json/json_parts.hpp"
#include "lab/scene/scene_files.hpp"

namespace quadrille::scoring {
namespace {

using nlohmann::ordered_json;

TrueSurface surface_of(const ordered_json& json) {
  TrueSurface surface;
  surface.id = json.at("id");
  // Without numbers of bodies each surface is a body.
  surface.body = json.value("body", -1 - surface.id);
  surface.curved = json.at("kind") == "quadric";
  surface.type = json.at("type");
  surface.Q_C = scene::quadric_of(json.at("q"));
  surface.X_CS = scene::pose_of(json.at("pose"));
  surface.box_S = scene::box_of(json.at("box"));
  surface.size = json.at("size");
  // The deviation is unknown for surfaces with too few points.
  if (!json.at("sigma").is_null()) surface.sigma = json.at("sigma");
  surface.evaluate = json.at("evaluate");
  return surface;
}

void take_truth(const ordered_json& truth, Frame* frame) {
  frame->family = truth.at("family");
  // Scenes with a simulated sensor name it.
  if (truth.contains("sensor")) {
    frame->family = truth.at("sensor").get<std::string>() + " " + frame->family;
  }
  frame->noise = truth.at("noise_scale");
  for (const ordered_json& object : truth.at("objects")) {
    // Clutter that is not a quadric has no coefficients.
    if (!object.at("q").is_null()) frame->surfaces.push_back(surface_of(object));
  }
}

/// Removes points that are not finite, and sets the normals of points without a surface to zero.
void clean(Frame* frame) {
  std::size_t kept = 0;
  const bool coloured = frame->cloud.coloured();
  for (std::size_t i = 0; i < frame->cloud.points.size(); ++i) {
    if (!frame->cloud.points[i].allFinite()) continue;
    frame->cloud.points[kept] = frame->cloud.points[i];
    if (coloured) frame->cloud.colours[kept] = frame->cloud.colours[i];
    frame->labels[kept] = frame->labels[i];
    frame->normals[kept] =
        frame->normals[i].allFinite() ? frame->normals[i] : Eigen::Vector3f::Zero();
    ++kept;
  }
  frame->cloud.points.resize(kept);
  if (coloured) frame->cloud.colours.resize(kept);
  frame->cloud.width = frame->cloud.height = 0;
  frame->labels.resize(kept);
  frame->normals.resize(kept);
}

/// Reads a file beside a cloud.
std::vector<std::byte> read_companion(const std::string& path) {
  if (!std::filesystem::exists(path)) {
    throw io::FileError(path, "",
                        "no such file; `quadrille scene --labels` makes clouds with all that is "
                        "known of them");
  }
  return io::read_file(path);
}

template <class Element>
std::vector<Element> read_elements(const std::string& path, std::size_t count) {
  const std::vector<std::byte> bytes = read_companion(path);
  if (bytes.size() != count * sizeof(Element)) {
    throw io::FileError(path, "", "has not one entry per point of the cloud; make both anew");
  }
  std::vector<Element> elements(count);
  std::memcpy(elements.data(), bytes.data(), bytes.size());
  return elements;
}

}  // namespace

Frame frame_of(const scene::Scene& scene) {
  Frame frame;
  take_truth(scene::truth_json(scene), &frame);
  frame.name = frame.family + " " + std::to_string(scene.options.seed);
  frame.cloud.points = scene.view.points;
  frame.cloud.read = frame.cloud.points.size();
  frame.labels = scene.view.labels;
  frame.normals = scene.view.normals;
  clean(&frame);
  return frame;
}

Frame read_frame(const std::string& ply_path) {
  Frame frame;
  frame.name = ply_path;
  frame.cloud = io::read_cloud(ply_path);
  const std::string truth = scene::find_truth(ply_path).value_or(scene::truth_path(ply_path));
  const std::vector<std::byte> bytes = read_companion(truth);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  try {
    take_truth(ordered_json::parse(text, text + bytes.size()), &frame);
  } catch (const ordered_json::exception& error) {
    throw io::json_error(truth, "no truth of a scene", error);
  }
  const std::string base = ply_path.substr(0, ply_path.size() - std::strlen(".ply"));
  const std::size_t count = frame.cloud.points.size();
  frame.labels = read_elements<int>(base + ".labels", count);
  const auto normals = read_elements<std::array<float, 3>>(base + ".normals", count);
  for (const auto& n : normals) frame.normals.emplace_back(n[0], n[1], n[2]);
  clean(&frame);
  return frame;
}

}  // namespace quadrille::scoring
