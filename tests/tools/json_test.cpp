#include "io/json/json.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "io/describe.hpp"
#include "io/planner/plan_json.hpp"
#include "io/run_info.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

Detection example_detection() {
  Detection d;
  d.id = 3;
  d.type = QuadricType::kCylinder;
  Vector10d q;
  q << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0 / 3.0;
  d.Q_C = Quadric(q);
  d.score = 0.75;
  d.inliers = 1234;
  d.rms = 0.0012;
  d.X_CQ.linear() = Eigen::AngleAxisd(3.5, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  d.X_CQ.translation() = Eigen::Vector3d(0.1, 0.2, 0.3);
  d.dimensions = {{"radius", 0.041, 0.0005}, {"length", 0.0909, 0.002}};
  d.extent_Q = {Eigen::Vector3d(-1, -2, -3), Eigen::Vector3d(1, 2, 3)};
  d.seen = 0.4;
  return d;
}

std::vector<std::string> keys_of(const io::Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

using Keys = std::vector<std::string>;

}  // namespace

TEST_CASE("the JSON of a detection has the promised keys, types and digits", "[json]") {
  DetectionResult result;
  result.detections = {example_detection()};
  result.points_finite = 10;
  result.points_used = 8;
  result.timings = {{"planes", 1.5}, {"vote", 2.5}};
  result.total_ms = 4.25;
  io::RunInfo run;
  run.seed = 7;
  run.settings["planes.sigmas"] = 2.5;
  run.warnings = {"The lens is dirty."};
  const io::Json json =
      io::Json::parse(io::detect_json({"a.ply", "cam", 12, 0.5, {1, 2, 3}}, run, result).dump());
  CHECK(keys_of(json) == Keys{"input", "version", "seed", "settings", "frame", "viewpoint",
                              "warnings", "points", "timings", "detections", "boxes", "bodies"});
  CHECK(json["seed"] == 7);
  CHECK(json["settings"] == io::Json({{"planes.sigmas", 2.5}}));
  CHECK(json["warnings"] == io::Json({"The lens is dirty."}));
  CHECK(json["input"] == "a.ply");
  CHECK(json["frame"] == "cam");
  CHECK(json["viewpoint"] == io::Json({1.0, 2.0, 3.0}));
  CHECK(json["points"] == io::Json({{"read", 12}, {"finite", 10}, {"used", 8}}));
  CHECK(keys_of(json["timings"]) == Keys{"read_ms", "total_ms", "planes_ms", "vote_ms"});
  CHECK(json["timings"]["total_ms"] == 4.25);
  const io::Json& d = json["detections"].at(0);
  CHECK(keys_of(d) == Keys{"id", "type", "q", "score", "inliers", "rms", "pose", "dimensions",
                           "extent", "std", "seen", "inside"});
  CHECK(d["type"] == "cylinder");
  REQUIRE(d["q"].size() == 10);
  CHECK(d["q"][9].get<double>() == 1.0 / 3.0);
  CHECK(d["dimensions"] == io::Json({{"radius", 0.041}, {"length", 0.0909}}));
  CHECK(d["std"] == io::Json({{"radius", 0.0005}, {"length", 0.002}}));
  CHECK(d["extent"]["max"] == io::Json({1.0, 2.0, 3.0}));
}

TEST_CASE("only a detection that is tracked has a track in JSON", "[json][track]") {
  Detection d = example_detection();
  CHECK_FALSE(io::to_json(d).contains("track"));
  d.track = 12;
  CHECK(io::to_json(d)["track"] == 12);
}

TEST_CASE("a body in JSON has the thickness of its wall, or null without one", "[json]") {
  SceneBody mug;
  mug.kind = BodyKind::kRevolution;
  CHECK(io::to_json(mug).at("wall").is_null());
  mug.wall = BodyWall{0.0045, 0.0015};
  const io::Json json = io::Json::parse(io::to_json(mug).dump());
  CHECK(json["wall"] == io::Json({{"thickness", 0.0045}, {"std", 0.0015}}));
  CHECK(io::describe_wall(*mug.wall) == "wall 4.5 ± 1.5 mm");
}

TEST_CASE("a quaternion in JSON is w x y z and turns as the pose does", "[json]") {
  const Detection d = example_detection();
  const io::Json q = io::to_json(d.X_CQ)["quaternion"];
  REQUIRE(q.size() == 4);
  CHECK(q[0].get<double>() >= 0.0);
  const Eigen::Quaterniond back(q[0], q[1], q[2], q[3]);
  CHECK((back.matrix() - d.X_CQ.linear()).norm() < 1e-12);
}

TEST_CASE("an empty result is JSON with empty lists", "[json]") {
  const io::Json detect = io::detect_json({}, {}, {});
  CHECK(detect["detections"] == io::Json::array());
  CHECK(detect["warnings"] == io::Json::array());
  CHECK(detect["settings"] == io::Json::object());
  const io::Json plan = io::plan_json({}, {}, {}, {});
  CHECK(plan["grasps"] == io::Json::array());
  CHECK(plan["shapes"] == io::Json::array());
  CHECK(plan["rejected"] == io::Json::object());
}

TEST_CASE("JSON never holds NaN, nor the bounds of an empty box", "[json][hostile]") {
  Detection d = example_detection();
  d.rms = std::numeric_limits<double>::quiet_NaN();
  d.dimensions[0].std = std::numeric_limits<double>::infinity();
  d.extent_Q.setEmpty();
  const io::Json json = io::Json::parse(io::to_json(d).dump());
  CHECK(json["rms"].is_null());
  CHECK(json["std"]["radius"].is_null());
  CHECK(json["extent"].is_null());
}

TEST_CASE("the JSON of a plan has the promised keys, and its total spans both halves", "[json]") {
  DetectionResult result;
  result.detections = {example_detection()};
  result.total_ms = 20.0;
  GraspPlan plan;
  plan.total_ms = 100.0;
  Grasp grasp;
  grasp.target = 3;
  grasp.contacts_C = {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6)};
  plan.grasps = {grasp};
  plan.rejected = {{"width", 2}, {"collision", 5}};
  plan.targets = {{3, 1, {}}, {4, 0, {{Refusal::kCollision, 5}, {Refusal::kWidth, 2}}}};
  CollisionShape shape;
  shape.target = 3;
  shape.kind = "cylinder";
  shape.dimensions = {0.041, 0.09};
  plan.shapes = {shape};
  io::RunInfo run;
  run.gripper = "claw";
  const io::Json json = io::plan_json({"a.ply", "cam", 12, 0.5}, run, result, plan);
  CHECK(keys_of(json) == Keys{"input", "version", "seed", "settings", "gripper", "frame",
                              "viewpoint", "warnings", "detections", "boxes", "bodies", "timings",
                              "grasps", "rejected", "targets", "shapes"});
  CHECK(json["gripper"] == "claw");
  CHECK(json["timings"]["total_ms"] == 120.0);
  CHECK(keys_of(json["grasps"][0]) == Keys{"target", "track", "kind", "score", "X_CG", "pregrasp",
                                           "retreat", "width", "preshape", "contacts", "approach",
                                           "friction_needed", "epsilon", "clearance",
                                           "unknown_contact", "terms"});
  CHECK(keys_of(json["grasps"][0]["X_CG"]) == Keys{"position", "quaternion"});
  CHECK(json["grasps"][0]["contacts"] == io::Json({{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}));
  CHECK(json["grasps"][0]["unknown_contact"].is_boolean());
  CHECK(json["rejected"] == io::Json({{"collision", 5}, {"width", 2}}));
  CHECK(json["targets"][0] == io::Json({{"target", 3},
                                        {"grasps", 1},
                                        {"rejected", io::Json::object()},
                                        {"furthest", {}},
                                        {"commonest", {}}}));
  CHECK(json["targets"][1] == io::Json({{"target", 4},
                                        {"grasps", 0},
                                        {"rejected", {{"width", 2}, {"collision", 5}}},
                                        {"furthest", "collision"},
                                        {"commonest", "collision"}}));
  CHECK(json["shapes"][0]["kind"] == "cylinder");
  CHECK(io::to_json({Remedy{4, "--gripper wsg50", 3, 0.75}}) ==
        io::Json::array(
            {{{"target", 4}, {"change", "--gripper wsg50"}, {"grasps", 3}, {"score", 0.75}}}));
}

TEST_CASE("labels name a detection with units", "[json]") {
  Detection d = example_detection();
  const Eigen::Vector4d diagonal(1.0, 1.0, 0.0, -0.041 * 0.041);
  d.Q_C = Quadric(Eigen::Matrix4d(diagonal.asDiagonal())).transformed(d.X_CQ);
  CHECK(io::name_of(d) == "3 cylinder");
  CHECK(io::short_label(d) == "3 cylinder r 41.0 l 90.9 mm");
  CHECK(io::describe_dimensions(d) == "radius 41.0 mm, length 90.9 mm");
  Detection inner = d;
  inner.Q_C = d.Q_C.flipped();
  CHECK(io::describe_dimensions(inner) == "radius 41.0 mm, length 90.9 mm, its inside");
  Detection hidden = d;
  hidden.dimensions[1].std = std::numeric_limits<double>::infinity();
  CHECK(io::describe_dimensions(hidden) == "radius 41.0 mm, length 90.9 mm*");
  CHECK(io::short_label(hidden) == "3 cylinder r 41.0 l 90.9 mm*");
  std::swap(hidden.dimensions[0].std, hidden.dimensions[1].std);
  CHECK(io::short_label(hidden) == "3 cylinder r 41.0* l 90.9 mm");
  d.type = QuadricType::kCone;
  d.dimensions = {{"half_angle", 0.5, 0.0}};
  CHECK(io::short_label(d) == "3 cone angle 28.6 deg");
}
