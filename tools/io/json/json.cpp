#include "io/json/json.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "io/json/json_parts.hpp"
#include "io/run_info.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::io {
namespace {

Json extent_of(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) return nullptr;
  return {{"min", array_of(box.min())}, {"max", array_of(box.max())}};
}

}  // namespace

Json to_json(const Eigen::Isometry3d& X) {
  const Eigen::Quaterniond R = rotation_of(X);
  return {{"position", array_of(X.translation())}, {"quaternion", {R.w(), R.x(), R.y(), R.z()}}};
}

Eigen::Isometry3d pose_of(const Json& json) {
  const auto p = json.at("position").get<std::array<double, 3>>();
  const auto q = json.at("quaternion").get<std::array<double, 4>>();
  const Eigen::Quaterniond R(q[0], q[1], q[2], q[3]);
  // It may miss unit length by rounding to a few digits.
  if (!(std::abs(R.norm() - 1.0) < 1e-3)) {
    throw std::invalid_argument("a quaternion w, x, y, z must have length 1 (its norm)");
  }
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = R.normalized().toRotationMatrix();
  X.translation() = Eigen::Vector3d(p.data());
  return X;
}

Json to_json(const Detection& detection) {
  Json dimensions = Json::object(), deviations = Json::object();
  for (const Dimension& dimension : detection.dimensions) {
    dimensions[dimension.name] = dimension.value;
    deviations[dimension.name] = dimension.std;
  }
  Json json = {{"id", detection.id},
               {"type", std::string(to_string(detection.type))},
               {"q", array_of(detection.Q_C.coefficients())},
               {"score", detection.score},
               {"inliers", detection.inliers},
               {"rms", detection.rms},
               {"pose", to_json(detection.X_CQ)},
               {"dimensions", dimensions},
               {"extent", extent_of(detection.extent_Q)},
               {"std", deviations},
               {"seen", detection.seen},
               {"inside", shows_inside(detection)}};
  if (detection.track > 0) json["track"] = detection.track;
  return json;
}

Json to_json(const Box& box) {
  return {{"id", box.id},
          {"faces", box.faces},
          {"score", box.score},
          {"pose", to_json(box.X_CB)},
          {"size", array_of(box.size)},
          {"std", array_of(box.std)},
          {"seen", box.seen},
          {"bounds", {{"inner", extent_of(box.inner_B)}, {"outer", extent_of(box.outer_B)}}}};
}

Json to_json(const std::vector<Box>& boxes) {
  Json array = Json::array();
  for (const Box& box : boxes) array.push_back(to_json(box));
  return array;
}

Json to_json(const BodyWall& wall) { return {{"thickness", wall.thickness}, {"std", wall.std}}; }

Json to_json(const SceneBody& body) {
  Json json = {{"id", body.id},
               {"kind", to_string(body.kind)},
               {"parts", body.parts},
               {"pose", to_json(body.X_CB)},
               {"size", array_of(body.size)},
               {"std", array_of(body.std)},
               {"seen", body.seen},
               {"wall", body.wall ? to_json(*body.wall) : Json()},
               {"standing_on", body.standing_on ? Json(*body.standing_on) : Json()},
               {"points", body.points},
               {"views", body.views},
               {"unseen", body.unseen}};
  if (body.track > 0) json["track"] = body.track;
  return json;
}

Json to_json(const std::vector<SceneBody>& bodies) {
  Json array = Json::array();
  for (const SceneBody& body : bodies) array.push_back(to_json(body));
  return array;
}

Json to_json(const std::vector<Detection>& detections) {
  Json array = Json::array();
  for (const Detection& detection : detections) array.push_back(to_json(detection));
  return array;
}

FileError json_error(const std::string& path, const std::string& what, const std::exception& error,
                     const std::string& cure) {
  if (const auto* wrong = dynamic_cast<const Json::parse_error*>(&error)) {
    return FileError(path, "byte " + std::to_string(wrong->byte), what + ": no JSON" + cure);
  }
  const bool is_ours = dynamic_cast<const Json::exception*>(&error) == nullptr;
  const std::string why =
      is_ours ? error.what() : "a key is missing, or its value is of another type";
  return FileError(path, "", what + ": " + why + cure);
}

void add_stages(const std::vector<StageTime>& stages, Json* timings) {
  for (const StageTime& stage : stages) (*timings)[stage.stage + "_ms"] = stage.ms;
}

Json begin_json(const InputInfo& input, const RunInfo& run) {
  Json json = {{"input", input.input},
               {"version", QUADRILLE_VERSION},
               {"seed", run.seed},
               {"settings", run.settings}};
  if (!run.gripper.empty()) json["gripper"] = run.gripper;
  json["frame"] = input.frame;
  json["viewpoint"] = array_of(input.viewpoint);
  json["warnings"] = run.warnings;
  return json;
}

Json detect_json(const InputInfo& input, const RunInfo& run, const DetectionResult& result) {
  Json timings = {{"read_ms", input.read_ms}, {"total_ms", result.total_ms}};
  add_stages(result.timings, &timings);
  Json json = begin_json(input, run);
  json["points"] = {
      {"read", input.points_read}, {"finite", result.points_finite}, {"used", result.points_used}};
  json["timings"] = timings;
  json["detections"] = to_json(result.detections);
  json["boxes"] = to_json(result.boxes);
  json["bodies"] = to_json(result.bodies);
  return json;
}

}  // namespace quadrille::io
