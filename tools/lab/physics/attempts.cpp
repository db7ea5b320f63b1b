#include "lab/physics/attempts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace quadrille::physics {
namespace {

Outcome outcome_of(const TrialResult& trial) {
  if (trial.held) return Outcome::kHeld;
  if (!trial.touched) return Outcome::kMissed;
  if (!trial.lifted) return Outcome::kDropped;
  return trial.slip >= kMaxSlip ? Outcome::kSlipped : Outcome::kTurned;
}

// Returns the body with its wall behind the side that was seen, at the place of the grasp.
TrueBody with_wall(TrueBody body, const Grasp& grasp, const SeenQuadrics& seen) {
  const auto target = seen.find(grasp.target);
  if (body.wall == 0.0 || target == seen.end()) return body;
  const Eigen::Vector3d p_S = body.X_CS.inverse() * grasp.X_CG.translation();
  const double angle = std::atan2(p_S.y() / body.b, p_S.x() / body.a);
  const double z = std::clamp(p_S.z(), body.z_min(), body.z_max());
  const Eigen::Vector3d outward_C = body.X_CS.linear() * body.normal_S(angle, z);
  const double out = target->second.gradient(body.X_CS * body.point_S(angle, z)).dot(outward_C);
  body.wall_at = (out > 0.0 ? -0.5 : 0.5) * body.wall;
  return body;
}

Attempt attempt(const Grasp& grasp, const SeenQuadrics& seen, const TrueScene& scene,
                const Gripper& gripper, const TrialOptions& options) {
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
  result.trial = try_grasp(with_wall(*body, grasp, seen), gripper, grasp, scene.X_CT, options);
  result.outcome = outcome_of(result.trial);
  return result;
}

}  // namespace

std::string to_string(Outcome outcome) {
  constexpr std::array kNames = {"held", "turned", "slipped", "dropped", "missed", "untried"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

SeenQuadrics seen_quadrics(const std::vector<Detection>& detections) {
  SeenQuadrics seen;
  for (const Detection& detection : detections) seen.emplace(detection.id, detection.Q_C);
  return seen;
}

std::vector<Attempt> try_grasps(const std::vector<Grasp>& grasps, const SeenQuadrics& seen,
                                const TrueScene& scene, const Gripper& gripper,
                                const TrialOptions& options, bool only_first,
                                const std::function<void(double)>& progress) {
  std::vector<Attempt> attempts;
  std::set<int> tried;
  for (std::size_t n = 0; n < grasps.size(); ++n) {
    if (progress) progress(static_cast<double>(n) / static_cast<double>(grasps.size()));
    const bool first = tried.insert(grasps[n].target).second;
    if (only_first && !first) continue;
    attempts.push_back(attempt(grasps[n], seen, scene, gripper, options));
    attempts.back().first = first;
  }
  return attempts;
}

}  // namespace quadrille::physics
