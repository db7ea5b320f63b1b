#include "quadrille/grasping/remedies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "quadrille/grasping/grasp_scene.hpp"

namespace quadrille {
namespace {

// A shorter approach than this share of the one that is set would hardly keep the hand off the
// object on the way in.
constexpr double kApproachShare = 0.5;
// The least score is offered in steps of this size.
constexpr double kScoreStep = 0.01;

/// Other settings for a plan.
struct Change {
  std::string text;
  Gripper gripper;
  PlanOptions options;
  GraspQuery query;
};

std::string text_of(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Returns the changes to be tried, except that of the least score.
std::vector<Change> changes(const Gripper& gripper, const PlanOptions& options,
                            const GraspQuery& query) {
  std::vector<Change> all;
  const auto add = [&](const std::string& text) -> Change& {
    return all.emplace_back(Change{text, gripper, options, query});
  };
  if (query.approach) add("without --approach").query.approach.reset();
  if (query.min_clearance > 0.0) add("without --min-clearance").query.min_clearance = 0.0;
  if (query.reach) {
    Change& change = add("without --reach");
    change.query.reach.reset();
    change.options.reach = {};
  }
  for (const auto& [word, policy] : words_of(UnknownPolicy{})) {
    if (policy != options.unknown && policy != UnknownPolicy::kObstacle &&
        options.unknown != UnknownPolicy::kFree) {
      add("--unknown " + std::string(word)).options.unknown = policy;
    }
  }
  const double approach = kApproachShare * options.approach;
  add("approach = " + text_of(approach) + " (under [planner] in --config FILE)").options.approach =
      approach;
  for (const Gripper& hand : built_in_grippers()) {
    if (hand.name != gripper.name) add("--gripper " + hand.name).gripper = hand;
  }
  return all;
}

/// Adds a remedy for each target that has grasps after a change.
void collect(const std::string& change, const GraspPlan& plan, std::vector<Remedy>& remedies) {
  for (const TargetOutcome& outcome : plan.targets) {
    if (outcome.grasps == 0) continue;
    Remedy& remedy = remedies.emplace_back(Remedy{outcome.target, change, outcome.grasps});
    for (const Grasp& grasp : plan.grasps) {
      if (grasp.target == outcome.target) remedy.score = std::max(remedy.score, grasp.score);
    }
  }
}

/// Adds the least score with which each target has a grasp.
void collect_scores(const GraspScene& scene, GraspQuery query, std::vector<Remedy>& remedies) {
  query.min_score = 0.0;
  std::vector<Remedy> best;
  collect("", scene.plan(query), best);
  for (const Remedy& remedy : best) {
    query.ids = {remedy.target};
    query.min_score = kScoreStep * std::floor(remedy.score / kScoreStep);
    // A search for better grasps may end before it comes to the same one.
    collect("--min-score " + text_of(*query.min_score), scene.plan(query), remedies);
  }
}

}  // namespace

std::vector<Remedy> find_remedies(const GraspPlan& plan, const PointCloud& cloud,
                                  const std::vector<Detection>& detections, const Gripper& gripper,
                                  const PlanOptions& options, const Surroundings& known,
                                  const GraspQuery& query, std::optional<std::vector<Box>> boxes,
                                  const std::vector<SceneBody>& bodies) {
  GraspQuery asked = completed(query, options);
  asked.ids.clear();
  asked.max_grasps = std::numeric_limits<int>::max();
  for (const TargetOutcome& outcome : plan.targets) {
    if (outcome.grasps == 0) asked.ids.push_back(outcome.target);
  }
  std::vector<Remedy> remedies;
  if (asked.ids.empty()) return remedies;
  const auto scene_for = [&](const Gripper& hand, const PlanOptions& with) {
    return GraspScene(cloud, detections, hand, with, known, boxes, bodies);
  };
  collect_scores(scene_for(gripper, options), asked, remedies);
  for (const Change& change : changes(gripper, options, asked)) {
    collect(change.text, scene_for(change.gripper, change.options).plan(change.query), remedies);
  }
  std::stable_sort(remedies.begin(), remedies.end(), [](const Remedy& a, const Remedy& b) {
    return std::pair(a.target, -a.score) < std::pair(b.target, -b.score);
  });
  return remedies;
}

}  // namespace quadrille
