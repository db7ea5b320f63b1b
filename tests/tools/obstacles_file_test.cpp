#include "io/planner/obstacles_file.hpp"

#include <nlohmann/json.hpp>

#include "io/json/json.hpp"
#include "io/planner/plan_json.hpp"
#include "quadrille/grasping/shape.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

io::Json file_of(const std::vector<CollisionShape>& shapes) {
  io::Json list = io::Json::array();
  for (const CollisionShape& shape : shapes) list.push_back(io::to_json(shape));
  return {{"shapes", list}};
}

std::vector<CollisionShape> some_shapes() {
  CollisionShape cylinder;
  cylinder.kind = "cylinder";
  cylinder.dimensions = {0.04, 0.12};
  cylinder.X_CS = Eigen::Translation3d(0.1, -0.2, 0.7) *
                  Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 1, 0).normalized());
  CollisionShape convex;
  convex.kind = "convex";
  convex.vertices_S = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  convex.faces = {3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
  return {with_geometry(cylinder), with_geometry(convex)};
}

TEST_CASE("the shapes that a plan writes are read as obstacles", "[obstacles]") {
  const test::TempFolder folder;
  const std::vector<CollisionShape> shapes = some_shapes();
  const std::string path = folder.write("obstacles.json", file_of(shapes).dump());
  const std::vector<CollisionShape> read = io::read_obstacles(path);
  REQUIRE(read.size() == shapes.size());
  for (std::size_t n = 0; n < read.size(); ++n) {
    CHECK(read[n].kind == shapes[n].kind);
    CHECK(read[n].X_CS.isApprox(shapes[n].X_CS));
    CHECK(read[n].dimensions == shapes[n].dimensions);
    CHECK(read[n].vertices_S == shapes[n].vertices_S);
    CHECK(read[n].faces == shapes[n].faces);
    CHECK(read[n].geometry);
  }
}

TEST_CASE("a bad file of obstacles is refused with the number of the shape", "[obstacles]") {
  const test::TempFolder folder;
  const auto error = [&](const std::string& text) {
    const std::string path = folder.write("bad.json", text);
    return test::error_of([&] { io::read_obstacles(path); });
  };
  CHECK(error("nonsense").find("no JSON") != std::string::npos);
  CHECK(error("{}").find("shapes") != std::string::npos);
  CHECK(error("[]").find("shapes") != std::string::npos);
  io::Json file = file_of(some_shapes());
  file["shapes"][1]["faces"][1] = 9;
  const std::string second = error(file.dump());
  CHECK(second.find("shape 2") != std::string::npos);
  CHECK(second.find("vertex") != std::string::npos);
  file = file_of(some_shapes());
  file["shapes"][0]["pose"]["quaternion"] = {1, 1, 0, 0};
  CHECK(error(file.dump()).find("length 1") != std::string::npos);
  file["shapes"][0].erase("pose");
  CHECK(error(file.dump()).find("shape 1") != std::string::npos);
  CHECK(test::error_of([&] {
          io::read_obstacles(folder.path("none.json"));
        }).find("no such file") != std::string::npos);
}

}  // namespace
}  // namespace quadrille
