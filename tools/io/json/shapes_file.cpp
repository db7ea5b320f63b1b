#include "io/json/shapes_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "io/file_bytes.hpp"
#include "io/json/json_parts.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

Eigen::Vector3d vector_of(const Json& json) {
  return Eigen::Vector3d(json.get<std::array<double, 3>>().data());
}

/// Refuses keys that nobody reads, since they are most likely misspelt.
void check_keys(const Json& object, const std::vector<std::string_view>& known) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw std::invalid_argument(
        fmt::format("unknown key '{}'; there are {}", printable(key), fmt::join(known, ", ")));
  }
}

/// @param json  a shape; "target" is there in those of a plan
SolidShape shape_of(const Json& json) {
  check_keys(json, {"kind", "pose", "dimensions", "vertices", "faces", "target"});
  check_keys(json.at("pose"), {"position", "quaternion"});
  SolidShape shape;
  shape.kind = json.at("kind");
  shape.X_CS = pose_of(json.at("pose"));
  if (shape.kind == "convex") {
    for (const Json& vertex : json.at("vertices")) shape.vertices_S.push_back(vector_of(vertex));
    shape.faces = json.at("faces").get<std::vector<int>>();
  } else {
    shape.dimensions = json.at("dimensions").get<std::vector<double>>();
  }
  shape.check();
  return shape;
}

}  // namespace

Json to_json(const SolidShape& shape) {
  Json json = {
      {"kind", shape.kind}, {"pose", to_json(shape.X_CS)}, {"dimensions", shape.dimensions}};
  if (shape.vertices_S.empty()) return json;
  json["vertices"] = Json::array();
  for (const Eigen::Vector3d& vertex : shape.vertices_S) {
    json["vertices"].push_back(array_of(vertex));
  }
  json["faces"] = shape.faces;
  return json;
}

RobotShapes read_robot(const std::string& path) {
  const std::vector<std::byte> bytes = read_file(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  RobotShapes robot;
  std::string place = "the top";
  try {
    const Json file = Json::parse(text);
    // The JSON of a whole plan has more keys; its shapes may serve as obstacles.
    if (!file.contains("grasps")) check_keys(file, {"padding", "shapes"});
    place = "padding";
    robot.padding = file.value("padding", robot.padding);
    robot.check();
    place = "shapes";
    for (const Json& shape : file.at("shapes")) {
      place = "shape " + std::to_string(robot.shapes.size() + 1);
      robot.shapes.push_back(shape_of(shape));
    }
  } catch (const std::exception& error) {
    throw json_error(path, "no file of shapes, at " + place, error,
                     "; give {\"shapes\": […]} as quadrille plan --json does");
  }
  return robot;
}

std::vector<SolidShape> read_shapes(const std::string& path) { return read_robot(path).shapes; }

}  // namespace quadrille::io
