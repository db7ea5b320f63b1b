#include "io/json/shapes_file.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/file_bytes.hpp"
#include "io/json/json.hpp"
#include "io/planner/plan_json.hpp"
#include "quadrille/grasping/shape.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

template <class Shape>
io::Json shapes_json(const std::vector<Shape>& shapes) {
  io::Json list = io::Json::array();
  for (const Shape& shape : shapes) list.push_back(io::to_json(shape));
  return {{"shapes", list}};
}

/// One shape of each kind, each at a pose of its own.
std::vector<SolidShape> one_of_each_kind() {
  const std::vector<std::pair<std::string, std::vector<double>>> kinds = {
      {"sphere", {0.05}},
      {"ellipsoid", {0.01, 0.02, 0.03}},
      {"cylinder", {0.04, 0.12}},
      {"capsule", {0.02, 0.15}},
      {"cone", {0.03, 0.09}},
      {"box", {0.1, 0.2, 0.3}},
      {"convex", {}}};
  std::vector<SolidShape> shapes;
  for (const auto& [kind, dimensions] : kinds) {
    SolidShape shape;
    shape.kind = kind;
    shape.dimensions = dimensions;
    const double n = static_cast<double>(shapes.size());
    shape.X_CS = Eigen::Translation3d(0.1 * n, -0.2, 0.7) *
                 Eigen::AngleAxisd(0.3 + n, Eigen::Vector3d(1, 1, 0).normalized());
    shapes.push_back(shape);
  }
  shapes.back().vertices_S = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  shapes.back().faces = {3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
  return shapes;
}

void check_same_shapes(const std::vector<SolidShape>& read, const std::vector<SolidShape>& shapes) {
  REQUIRE(read.size() == shapes.size());
  for (std::size_t n = 0; n < read.size(); ++n) {
    CAPTURE(shapes[n].kind);
    CHECK(read[n].kind == shapes[n].kind);
    CHECK(read[n].X_CS.isApprox(shapes[n].X_CS));
    CHECK(read[n].dimensions == shapes[n].dimensions);
    CHECK(read[n].vertices_S == shapes[n].vertices_S);
    CHECK(read[n].faces == shapes[n].faces);
  }
}

TEST_CASE("shapes of all kinds are read as they were written", "[shapes]") {
  const test::TempFolder folder;
  const std::vector<SolidShape> shapes = one_of_each_kind();
  check_same_shapes(io::read_shapes(folder.write("shapes.json", shapes_json(shapes).dump())),
                    shapes);
}

TEST_CASE("the shapes that a plan writes are read as obstacles", "[shapes][obstacles]") {
  const test::TempFolder folder;
  std::vector<CollisionShape> planned;
  for (const SolidShape& shape : one_of_each_kind()) planned.push_back(with_geometry(shape));
  const std::string path = folder.write("obstacles.json", shapes_json(planned).dump());
  check_same_shapes(io::read_shapes(path), one_of_each_kind());
}

TEST_CASE("a file by hand is read as it says", "[shapes]") {
  const test::TempFolder folder;
  const std::string path = folder.write("hand.json", R"({"padding": 0.02, "shapes": [
      {"kind": "box", "dimensions": [0.1, 0.2, 0.3],
       "pose": {"position": [1, 2, 3], "quaternion": [0, 0, 0, 1]}}]})");
  const RobotShapes robot = io::read_robot(path);
  CHECK(robot.padding == 0.02);
  REQUIRE(robot.shapes.size() == 1);
  // Half a turn about z.
  CHECK((robot.shapes[0].X_CS * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(0, 2, 3)));
  CHECK(io::read_robot(folder.write("none.json", R"({"shapes": []})")).padding ==
        RobotShapes{}.padding);
}

TEST_CASE("a bad file of shapes is refused with the number of the shape", "[shapes][obstacles]") {
  const test::TempFolder folder;
  const auto error = [&](const std::string& text) {
    const std::string path = folder.write("bad.json", text);
    CHECK_THROWS_AS(io::read_shapes(path), io::FileError);
    return test::error_of([&] { io::read_shapes(path); });
  };
  const auto changed = [](const auto& change) {
    io::Json file = shapes_json(one_of_each_kind());
    change(file);
    return file.dump();
  };
  CHECK(error("nonsense").find("no JSON") != std::string::npos);
  CHECK(error("{}").find("shapes") != std::string::npos);
  CHECK(error("[]").find("shapes") != std::string::npos);
  CHECK(error("null").find("shapes") != std::string::npos);
  const std::string seventh = error(changed([](io::Json& f) { f["shapes"][6]["faces"][1] = 9; }));
  CHECK(seventh.find("shape 7") != std::string::npos);
  CHECK(seventh.find("vertex") != std::string::npos);
  CHECK(error(changed([](io::Json& f) {
          f["shapes"][0]["pose"]["quaternion"] = {1, 1, 0, 0};
        })).find("length 1") != std::string::npos);
  CHECK(error(changed([](io::Json& f) { f["shapes"][2].erase("pose"); })).find("shape 3") !=
        std::string::npos);
  CHECK(error(changed([](io::Json& f) {
          f["shapes"][1]["dimensions"] = {1, 2};
        })).find("3 sizes") != std::string::npos);
  CHECK(error(changed([](io::Json& f) {
          f["shapes"][1]["dimensions"] = "large";
        })).find("shape 2") != std::string::npos);
  CHECK(error(changed([](io::Json& f) { f["shapes"][4]["kind"] = 7; })).find("shape 5") !=
        std::string::npos);
  CHECK(error(changed([](io::Json& f) { f["shapes"][3]["kind"] = "pill"; })).find("capsule") !=
        std::string::npos);
  CHECK(error(changed([](io::Json& f) { f["padding"] = -0.01; })).find("padding") !=
        std::string::npos);
  CHECK_FALSE(error(changed([](io::Json& f) { f["padding"] = "wide"; })).empty());
  CHECK(test::error_of([&] { io::read_shapes(folder.path("none.json")); }).find("no such file") !=
        std::string::npos);
}

TEST_CASE("a key that nobody reads is refused where it stands", "[shapes]") {
  const test::TempFolder folder;
  const auto error = [&](const auto& change) {
    io::Json file = shapes_json(one_of_each_kind());
    change(file);
    return test::error_of([&] { io::read_shapes(folder.write("keys.json", file.dump())); });
  };
  const auto holds = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string top = error([](io::Json& f) { f["pading"] = 0.02; });
  CHECK(holds(top, "at the top: unknown key 'pading'; there are padding, shapes"));
  const std::string second = error([](io::Json& f) { f["shapes"][1]["dimension"] = 1; });
  CHECK(holds(second, "shape 2: unknown key 'dimension'; there are kind, pose, dimensions"));
  CHECK(holds(error([](io::Json& f) { f["shapes"][2]["pose"]["rotation"] = 1; }), "'rotation'"));
  CHECK(holds(error([](io::Json& f) { f["a\nb"] = 1; }), "unknown key 'a\\x0ab'"));
  // A whole plan has more keys, and its shapes are obstacles.
  CHECK(error([](io::Json& f) { f["grasps"] = f["settings"] = io::Json::array(); }).empty());
}

TEST_CASE("a file of shapes that is cut anywhere is refused", "[shapes][hostile]") {
  const test::TempFolder folder;
  const std::string whole = shapes_json(one_of_each_kind()).dump();
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    CAPTURE(size);
    const std::string path = folder.write("cut.json", whole.substr(0, size));
    CHECK_THROWS_AS(io::read_shapes(path), io::FileError);
  }
}

}  // namespace
}  // namespace quadrille
