#include "io/planner/obstacles_file.hpp"

#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/file_bytes.hpp"
#include "io/json/json_parts.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille::io {
namespace {

Eigen::Vector3d vector_of(const Json& json) {
  return Eigen::Vector3d(json.get<std::array<double, 3>>().data());
}

CollisionShape shape_of(const Json& json) {
  CollisionShape shape;
  shape.kind = json.at("kind");
  shape.X_CS = pose_of(json.at("pose"));
  if (shape.kind == "convex") {
    for (const Json& vertex : json.at("vertices")) shape.vertices_S.push_back(vector_of(vertex));
    shape.faces = json.at("faces").get<std::vector<int>>();
  } else {
    shape.dimensions = json.at("dimensions").get<std::vector<double>>();
  }
  return with_geometry(std::move(shape));
}

}  // namespace

std::vector<CollisionShape> read_obstacles(const std::string& path) {
  const std::vector<std::byte> bytes = read_file(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::vector<CollisionShape> shapes;
  try {
    const Json file = Json::parse(text);
    for (const Json& shape : file.at("shapes")) shapes.push_back(shape_of(shape));
  } catch (const std::exception& error) {
    const std::string number = std::to_string(shapes.size() + 1);
    throw json_error(path, "no file of obstacles, at shape " + number, error,
                     "; give {\"shapes\": […]} as quadrille plan --json does");
  }
  return shapes;
}

}  // namespace quadrille::io
