#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "lab/physics/attempts.hpp"
#include "lab/physics/trial.hpp"
#include "lab/physics/true_scene.hpp"
#include "lab/study/grasp_judge.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan_options.hpp"

namespace quadrille::study {

/// Which grasps are tried in the physics engine.
enum class Tries { kNone, kFirst, kAll };

/// The options with which every scene of a study is processed.
struct StudyOptions {
  Gripper gripper;
  DetectorOptions detector;
  PlanOptions plan;
  physics::TrialOptions trial;
  /// Whether no grasp, the best grasp of each target, or every grasp is tried.
  Tries tries = Tries::kFirst;
};

/// A cloud in frame K, the frame's pose in the frame C of results and truth, and the truth.
struct StudyInput {
  PointCloud cloud;
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity();
  std::optional<physics::TrueScene> truth;
};

/// One grasp in frame C, and what became of it.
struct GraspRecord {
  Grasp grasp;
  /// True for the best ranked grasp of its target; and the detected type of the target.
  bool first = false;
  std::string target_type;
  /// The verdict, if there is a ground truth.
  std::optional<Verdict> verdict;
  /// Id and type of the true object between the pads; -1 if there is none.
  int object = -1;
  std::string object_type;
  /// The trial, if the grasp was tried.
  std::optional<physics::Attempt> attempt;
};

/// Counts of the true objects that are visible enough and can be held: those that are somewhere
/// narrower than the hand's opening, or are open at the top with a rim. The others count how many
/// of these have a grasp, a good first grasp, and a first grasp that held.
struct ObjectCounts {
  int all = 0, with_grasp = 0, with_good = 0, with_held = 0;
};

/// The results of one scene that a study keeps.
struct SceneRecord {
  std::size_t points = 0;
  int detections = 0, boxes = 0, rejected = 0;
  /// The grasps, best first.
  std::vector<GraspRecord> grasps;
  /// The counts, if there is a ground truth.
  std::optional<ObjectCounts> objects;
};

/// Finds quadrics, plans grasps as `quadrille plan` does, judges them and tries them.
/// @throws std::invalid_argument if an option is out of range
/// @throws std::runtime_error if grasps are to be tried but the physics engine is missing
SceneRecord study_scene(const StudyInput& input, const StudyOptions& options);

}  // namespace quadrille::study
