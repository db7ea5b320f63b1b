#include "io/planner/plan_json.hpp"

#include <octomap/OcTree.h>

#include <cmath>

#include "io/json/json_parts.hpp"
#include "io/json/shapes_file.hpp"
#include "io/run_info.hpp"

namespace quadrille::io {

Json to_json(const Grasp& grasp) {
  Json terms;
  GraspTerms::visit(grasp.terms, [&](const char* name, double term) { terms[name] = term; });
  return {{"target", grasp.target},
          {"track", grasp.track},
          {"kind", to_string(grasp.kind)},
          {"score", grasp.score},
          {"X_CG", to_json(grasp.X_CG)},
          {"pregrasp", to_json(grasp.pregrasp())},
          {"retreat", to_json(grasp.pregrasp())},
          {"width", grasp.width},
          {"preshape", grasp.preshape},
          {"contacts", {array_of(grasp.contacts_C[0]), array_of(grasp.contacts_C[1])}},
          {"approach", grasp.approach},
          {"friction_needed", grasp.friction_needed},
          {"epsilon", grasp.epsilon},
          {"clearance", grasp.clearance},
          {"unknown_contact", grasp.unknown_contact},
          {"terms", terms}};
}

Json to_json(const CollisionShape& shape) {
  Json json = {{"target", shape.target}};
  json.update(to_json(static_cast<const SolidShape&>(shape)));
  return json;
}

Json to_json(const Surroundings& known) {
  Json json = Json::object();
  if (!known.robot.shapes.empty()) {
    json["robot"] = {{"padding", known.robot.padding}, {"shapes", Json::array()}};
    for (const SolidShape& shape : known.robot.shapes) {
      json["robot"]["shapes"].push_back(to_json(shape));
    }
  }
  if (known.support) {
    json["support"] = array_of(known.support->n_C);
    json["support"].push_back(known.support->offset);
  }
  if (known.map.tree) {
    json["octomap"] = {{"resolution", known.map.tree->getResolution()},
                       {"nodes", known.map.tree->size()}};
  }
  return json;
}

Json to_json(const TargetOutcome& outcome) {
  Json rejected = Json::object();
  for (const auto& [why, count] : outcome.refusals) rejected[std::string(to_string(why))] = count;
  Json json = {{"target", outcome.target}, {"grasps", outcome.grasps}, {"rejected", rejected}};
  const std::optional<Refusal> why = furthest(outcome.refusals);
  json["furthest"] = why ? Json(to_string(*why)) : Json(nullptr);
  const std::optional<Refusal> most = commonest(outcome.refusals);
  json["commonest"] = most ? Json(to_string(*most)) : Json(nullptr);
  return json;
}

Json to_json(const std::vector<Remedy>& remedies) {
  Json list = Json::array();
  for (const Remedy& remedy : remedies) {
    list.push_back({{"target", remedy.target},
                    {"change", remedy.change},
                    {"grasps", remedy.grasps},
                    {"score", remedy.score}});
  }
  return list;
}

Json to_json(const std::vector<Look>& looks) {
  Json list = Json::array();
  for (const Look& look : looks) {
    list.push_back({{"pose", to_json(look.X_CK)}, {"bodies", look.bodies}, {"gain", look.gain}});
  }
  return list;
}

Json to_json(const GraspQuery& query) {
  Json json = Json::object();
  if (!query.ids.empty()) json["target"] = query.ids;
  if (!query.tracks.empty()) json["tracks"] = query.tracks;
  const auto add_shapes = [&](const char* name, const std::vector<CollisionShape>& shapes) {
    if (shapes.empty()) return;
    json[name] = Json::array();
    for (const CollisionShape& shape : shapes) json[name].push_back(to_json(shape));
  };
  add_shapes("obstacles", query.obstacles);
  add_shapes("attached", query.attached);
  if (query.near_C) json["near"] = array_of(*query.near_C);
  if (query.region) {
    json["roi"] = {{"pose", to_json(query.region->X_CR)},
                   {"min", array_of(query.region->box_R.min())},
                   {"max", array_of(query.region->box_R.max())}};
  }
  if (query.min_size > 0.0) json["min_size"] = query.min_size;
  if (std::isfinite(query.max_size)) json["max_size"] = query.max_size;
  if (query.min_clearance > 0.0) json["min_clearance"] = query.min_clearance;
  if (query.approach) {
    json["approach"] = {{"direction", array_of(query.approach->axis_C)},
                        {"angle", query.approach->half_angle}};
  }
  if (query.reach) {
    json["reach"] = {{"base", array_of(query.reach->base_C)},
                     {"min", query.reach->min},
                     {"max", query.reach->max}};
  }
  if (query.min_score) json["min_score"] = *query.min_score;
  if (query.per_target) json["per_target"] = *query.per_target;
  if (query.max_grasps) json["best"] = *query.max_grasps;
  return json;
}

Json plan_json(const InputInfo& input, const RunInfo& run, const DetectionResult& result,
               const GraspPlan& plan) {
  Json timings = {{"read_ms", input.read_ms},
                  {"total_ms", result.total_ms + plan.total_ms},
                  {"detect_ms", result.total_ms},
                  {"plan_ms", plan.total_ms}};
  add_stages(plan.timings, &timings);
  Json grasps = Json::array(), shapes = Json::array(), targets = Json::array();
  for (const Grasp& grasp : plan.grasps) grasps.push_back(to_json(grasp));
  for (const CollisionShape& shape : plan.shapes) shapes.push_back(to_json(shape));
  for (const TargetOutcome& outcome : plan.targets) targets.push_back(to_json(outcome));
  Json json = begin_json(input, run);
  json["detections"] = to_json(result.detections);
  json["boxes"] = to_json(result.boxes);
  json["bodies"] = to_json(result.bodies);
  json["timings"] = timings;
  json["grasps"] = grasps;
  json["rejected"] = plan.rejected;
  json["targets"] = targets;
  json["shapes"] = shapes;
  return json;
}

}  // namespace quadrille::io
