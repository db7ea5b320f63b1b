#include "physics/attempts.hpp"

#include <set>

namespace quadrille::physics {
namespace {

Outcome outcome_of(const TrialResult& trial) {
  if (trial.held) return Outcome::kHeld;
  if (!trial.touched) return Outcome::kMissed;
  if (!trial.lifted) return Outcome::kDropped;
  return trial.slip >= kMostSlip ? Outcome::kSlipped : Outcome::kTurned;
}

Attempt attempt(const Grasp& grasp, const TrueScene& scene, const Gripper& gripper,
                const TrialOptions& options) {
  Attempt result;
  result.target = grasp.target;
  result.score = grasp.score;
  result.width = grasp.width;
  const Eigen::Vector3d between(0.5 * gripper.finger.x(), 0.5 * grasp.preshape,
                                0.5 * gripper.pad.y());
  const TrueBody* body = body_in(scene, grasp.X_CG, between);
  if (body == nullptr) {
    const bool clutter = near_clutter(scene, grasp.X_CG.translation(), 0.5 * grasp.preshape);
    result.outcome = clutter ? Outcome::kUntried : Outcome::kMissed;
    return result;
  }
  result.object = body->id;
  result.type = body->type;
  result.trial = try_grasp(*body, gripper, grasp, scene.X_CT, options);
  result.outcome = outcome_of(result.trial);
  return result;
}

}  // namespace

std::string to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::kHeld:
      return "held";
    case Outcome::kTurned:
      return "turned";
    case Outcome::kSlipped:
      return "slipped";
    case Outcome::kDropped:
      return "dropped";
    case Outcome::kMissed:
      return "missed";
    case Outcome::kUntried:
      break;
  }
  return "untried";
}

std::vector<Attempt> try_grasps(const std::vector<Grasp>& grasps, const TrueScene& scene,
                                const Gripper& gripper, const TrialOptions& options,
                                bool only_first, const std::function<void(double)>& progress) {
  std::vector<Attempt> attempts;
  std::set<int> seen;
  for (std::size_t n = 0; n < grasps.size(); ++n) {
    if (progress) progress(static_cast<double>(n) / static_cast<double>(grasps.size()));
    const bool first = seen.insert(grasps[n].target).second;
    if (only_first && !first) continue;
    attempts.push_back(attempt(grasps[n], scene, gripper, options));
    attempts.back().first = first;
  }
  return attempts;
}

}  // namespace quadrille::physics
