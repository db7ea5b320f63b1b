#include "io/json.hpp"

#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille::io {
namespace {

template <class Vector>
Json array_of(const Vector& v) {
  Json array = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) array.push_back(v[i]);
  return array;
}

Json extent_of(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) return nullptr;
  return {{"min", array_of(box.min())}, {"max", array_of(box.max())}};
}

Json detections_of(const DetectionResult& result) {
  Json array = Json::array();
  for (const Detection& detection : result.detections) array.push_back(to_json(detection));
  return array;
}

void add_stages(const std::vector<StageTime>& stages, Json* timings) {
  for (const StageTime& stage : stages) (*timings)[stage.stage + "_ms"] = stage.ms;
}

}  // namespace

Json to_json(const Eigen::Isometry3d& X) {
  const pose_t pose = bus::to_message(X);
  return {{"position", pose.position}, {"quaternion", pose.quaternion}};
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
               {"seen", detection.seen}};
  if (detection.track > 0) json["track"] = detection.track;
  return json;
}

Json to_json(const Grasp& grasp) {
  return {{"target", grasp.target},
          {"score", grasp.score},
          {"X_CG", to_json(grasp.X_CG)},
          {"width", grasp.width},
          {"preshape", grasp.preshape},
          {"contacts", {array_of(grasp.contacts_C[0]), array_of(grasp.contacts_C[1])}},
          {"approach", grasp.approach},
          {"friction_needed", grasp.friction_needed},
          {"epsilon", grasp.epsilon},
          {"clearance", grasp.clearance},
          {"unknown_contact", grasp.unknown_contact}};
}

Json to_json(const CollisionShape& shape) {
  Json json = {{"target", shape.target},
               {"kind", shape.kind},
               {"pose", to_json(shape.X_CS)},
               {"dimensions", shape.dimensions}};
  if (!shape.vertices_S.empty()) {
    json["vertices"] = Json::array();
    for (const Eigen::Vector3d& vertex : shape.vertices_S) {
      json["vertices"].push_back(array_of(vertex));
    }
    json["faces"] = shape.faces;
  }
  return json;
}

Json detect_json(const InputInfo& input, const DetectionResult& result) {
  Json timings = {{"read_ms", input.read_ms}, {"total_ms", result.total_ms}};
  add_stages(result.timings, &timings);
  return {{"input", input.input},
          {"frame", input.frame},
          {"points",
           {{"read", input.points_read},
            {"finite", result.points_finite},
            {"used", result.points_used}}},
          {"timings", timings},
          {"detections", detections_of(result)}};
}

Json plan_json(const InputInfo& input, const DetectionResult& result, const GraspPlan& plan) {
  Json timings = {{"read_ms", input.read_ms},
                  {"total_ms", result.total_ms + plan.total_ms},
                  {"detect_ms", result.total_ms},
                  {"plan_ms", plan.total_ms}};
  add_stages(plan.timings, &timings);
  Json grasps = Json::array(), shapes = Json::array();
  for (const Grasp& grasp : plan.grasps) grasps.push_back(to_json(grasp));
  for (const CollisionShape& shape : plan.shapes) shapes.push_back(to_json(shape));
  return {{"input", input.input}, {"detections", detections_of(result)}, {"timings", timings},
          {"grasps", grasps},     {"rejected", Json(plan.rejected)},     {"shapes", shapes}};
}

}  // namespace quadrille::io
