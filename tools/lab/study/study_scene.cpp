#include "lab/study/study_scene.hpp"

#include <map>
#include <set>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille::study {
namespace {

std::vector<GraspRecord> records_of(const GraspPlan& plan,
                                    const std::vector<Detection>& detections) {
  std::map<int, std::string> types;
  for (const Detection& d : detections) types[d.id] = std::string(to_string(d.type));
  for (const Box& box : plan.boxes) types[box.id] = "box";
  std::vector<GraspRecord> records;
  std::set<int> seen;
  for (const Grasp& grasp : plan.grasps) {
    GraspRecord& record = records.emplace_back();
    record.grasp = grasp;
    record.first = seen.insert(grasp.target).second;
    record.target_type = types[grasp.target];
  }
  return records;
}

void judge_all(const physics::TrueScene& truth, const StudyOptions& options,
               std::vector<GraspRecord>* records) {
  const GraspJudge judge(truth, options.gripper, options.trial.friction);
  for (GraspRecord& record : *records) {
    const Judgement judgement = judge.judge(record.grasp);
    record.verdict = judgement.verdict;
    if (judgement.object == nullptr) continue;
    record.object = judgement.object->id;
    record.object_type = judgement.object->type;
  }
}

void try_all(const GraspPlan& plan, const std::vector<Detection>& detections,
             const physics::TrueScene& truth, const StudyOptions& options,
             std::vector<GraspRecord>* records) {
  if (options.tries == Tries::kNone) return;
  const bool only_first = options.tries == Tries::kFirst;
  const std::vector<physics::Attempt> attempts =
      physics::try_grasps(plan.grasps, physics::seen_quadrics(detections), truth, options.gripper,
                          options.trial, only_first, {});
  std::size_t next = 0;
  for (GraspRecord& record : *records) {
    if (record.first || !only_first) record.attempt = attempts.at(next++);
  }
}

bool is_held(const GraspRecord& record) {
  return record.attempt && record.attempt->outcome == physics::Outcome::kHeld;
}

/// Returns true if the hand may be able to hold the body at all: across it, or by the wall of a
/// vessel.
bool may_be_held(const physics::TrueBody& body, const Gripper& gripper) {
  return body.wall > 0.0 || body.box_S.sizes().minCoeff() < gripper.max_opening;
}

ObjectCounts count_objects(const physics::TrueScene& truth, const Gripper& gripper,
                           const std::vector<GraspRecord>& records) {
  ObjectCounts counts;
  for (const physics::TrueBody& body : truth.bodies) {
    if (!body.is_seen || !may_be_held(body, gripper)) continue;
    bool any = false, good = false, held = false;
    for (const GraspRecord& record : records) {
      if (record.object != body.id) continue;
      any = true;
      good |= record.first && record.verdict == Verdict::kGood;
      held |= record.first && is_held(record);
    }
    ++counts.all;
    counts.with_grasp += any;
    counts.with_good += good;
    counts.with_held += held;
  }
  return counts;
}

}  // namespace

SceneRecord study_scene(const StudyInput& input, const StudyOptions& options) {
  DetectionResult result = detect(input.cloud, options.detector);
  const GraspQuery query = moved(completed({}, options.plan), input.X_CK.inverse());
  const GraspPlan plan = moved(plan_grasps(input.cloud, result.detections, options.gripper,
                                           options.plan, {}, query, result.boxes, result.bodies),
                               input.X_CK);
  const std::vector<Detection> detections = moved(std::move(result.detections), input.X_CK);
  SceneRecord record;
  record.points = input.cloud.points.size();
  record.detections = static_cast<int>(detections.size());
  record.boxes = static_cast<int>(plan.boxes.size());
  for (const auto& [reason, count] : plan.rejected) record.rejected += count;
  record.grasps = records_of(plan, detections);
  if (!input.truth) return record;
  judge_all(*input.truth, options, &record.grasps);
  try_all(plan, detections, *input.truth, options, &record.grasps);
  record.objects = count_objects(*input.truth, options.gripper, record.grasps);
  return record;
}

}  // namespace quadrille::study
