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

/// With what every scene of a study is worked on.
struct StudyOptions {
  Gripper gripper;
  DetectorOptions detector;
  PlanOptions plan;
  physics::TrialOptions trial;
  /// Of each target the best grasp, or all.
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
  /// The best ranked one of its target, and what that was found to be.
  bool first = false;
  std::string target_type;
  /// Only with a truth.
  std::optional<Verdict> verdict;
  /// Id and type of the true object between the pads; -1 if there is none.
  int object = -1;
  std::string object_type;
  /// Only if it was tried.
  std::optional<physics::Attempt> attempt;
};

/// Of the true objects those that are seen enough, and are somewhere narrower than the hand opens
/// or open to above with a rim to hold; and how many of them got a grasp at all, a first one that
/// is good, a first one that held.
struct ObjectCounts {
  int all = 0, with_grasp = 0, with_good = 0, with_held = 0;
};

/// What a study keeps of one scene.
struct SceneRecord {
  std::size_t points = 0;
  int detections = 0, boxes = 0, rejected = 0;
  /// Best first.
  std::vector<GraspRecord> grasps;
  /// Only with a truth.
  std::optional<ObjectCounts> objects;
};

/// Finds quadrics, plans grasps as `quadrille plan` does, judges them and tries them.
/// @throws std::invalid_argument if an option is out of range
/// @throws std::runtime_error if grasps are to be tried and there is no physics
SceneRecord study_scene(const StudyInput& input, const StudyOptions& options);

}  // namespace quadrille::study
