#pragma once

#include <string>
#include <vector>

#include "lab/study/rows.hpp"

namespace quadrille::test {

inline study::StudyOptions study_with(const char* gripper) {
  study::StudyOptions options;
  options.gripper = gripper_by_name(gripper);
  return options;
}

inline study::Label label_with(const char* gripper, const char* settings = "x") {
  return study::label_of(study_with(gripper), "1.2.3", "tabletop", settings);
}

/// Scenes 1, 2, … with the seeds 11, 12, …
inline std::vector<study::SceneName> names_of(int count) {
  std::vector<study::SceneName> names;
  for (int n = 1; n <= count; ++n) {
    const std::string seed = std::to_string(10 + n);
    names.push_back({n, "tabletop " + seed, seed});
  }
  return names;
}

/// The best grasp of a target, judged and tried.
inline study::GraspRecord first_grasp(int target, double score, study::Verdict verdict,
                                      physics::Outcome outcome) {
  study::GraspRecord record;
  record.grasp.target = target;
  record.grasp.score = score;
  record.first = true;
  record.target_type = "sphere";
  record.verdict = verdict;
  record.object = target;
  record.object_type = "sphere";
  record.attempt.emplace().outcome = outcome;
  return record;
}

/// Two objects, two first grasps: one held and good, one dropped that touches; and a third grasp
/// that is good and was not tried.
inline study::SceneRecord typical_scene() {
  study::SceneRecord record;
  record.points = 1000;
  record.grasps = {first_grasp(1, 0.9, study::Verdict::kGood, physics::Outcome::kHeld),
                   first_grasp(2, 0.4, study::Verdict::kTouches, physics::Outcome::kDropped)};
  record.grasps.push_back(record.grasps.front());
  record.grasps.back().first = false;
  record.grasps.back().attempt.reset();
  record.objects = study::ObjectCounts{4, 2, 1, 1};
  return record;
}

}  // namespace quadrille::test
