#include "io/json/shapes_file.hpp"

#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/file_bytes.hpp"
#include "io/json/json_parts.hpp"

namespace quadrille::io {
namespace {

Eigen::Vector3d vector_of(const Json& json) {
  return Eigen::Vector3d(json.get<std::array<double, 3>>().data());
}

SolidShape shape_of(const Json& json) {
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
  std::string place = "padding";
  try {
    const Json file = Json::parse(text);
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
