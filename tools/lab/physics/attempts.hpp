#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lab/physics/trial.hpp"
#include "lab/physics/true_scene.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille::physics {

/// How a grasp ended.
enum class Outcome {
  kHeld,     ///< lifted, with little slip and rotation
  kTurned,   ///< lifted, but turned in the hand by 5° or more
  kSlipped,  ///< lifted, but slipped by 5 mm or more
  kDropped,  ///< taken hold of, then lost
  kMissed,   ///< nothing between the pads, or only one of them touched it
  kUntried,  ///< on clutter, whose shape the truth does not describe
};

/// Returns "held", "turned", "slipped", "dropped", "missed" or "untried".
std::string to_string(Outcome outcome);

/// One planned grasp, tried on the true object between its pads.
struct Attempt {
  int target = 0;
  /// True for the best-ranked grasp of its target.
  bool first = false;
  double score = 0.0, width = 0.0;
  /// Id and type of the object in the ground truth; -1 and "nothing" if there is none.
  int object = -1;
  std::string type = "nothing";
  Outcome outcome = Outcome::kMissed;
  TrialResult trial;
};

/// The quadrics of a plan's detections by id; the gradient points to the side that the sensor saw.
using SeenQuadrics = std::map<int, Quadric>;

SeenQuadrics seen_quadrics(const std::vector<Detection>& detections);

/// Tries the grasps of a plan, best first. Generated vessels have no thickness; here the wall lies
/// behind the side of the target's surface that the sensor saw, as in a real vessel.
/// @param only_first  tries only the best grasp of each target
/// @param progress    called with the share that is done; may be empty
/// @throws as try_grasp() does
std::vector<Attempt> try_grasps(const std::vector<Grasp>& grasps, const SeenQuadrics& seen,
                                const TrueScene& scene, const Gripper& gripper,
                                const TrialOptions& options, bool only_first,
                                const std::function<void(double)>& progress);

}  // namespace quadrille::physics
