// Finds grasps across the wall of a vessel, at its rim.
#include "contacts/rim.hpp"

#include <utility>
#include <vector>

#include "contacts/closing.hpp"
#include "contacts/quality.hpp"
#include "contacts/wall_hold.hpp"
#include "targets/hand_trials.hpp"

namespace quadrille {
namespace {

// Limits on the effort per target, as for grasps across a body.
constexpr int kMaxChecks = 4000;
constexpr std::size_t kUsualGrasps = 12;
// Walls with more warp under the pads turn in the hand. The limit is a share of a pad's reach: at
// the corners this is 4° out of line, out of the 5° that a held object may turn.
constexpr double kMaxWarpToReach = 1.0 / 15.0;

/// Places the tips as far beyond the contacts as the rim is in front of them, so that the bend of
/// the wall turns it neither way.
void try_rim(const ContactLine& line, const Eigen::Vector3d& approach_C, const TargetTask& task,
             HandTrials& trials) {
  const Shell& shell = *task.target.shell;
  const Gripper& gripper = task.parts.gripper;
  const double warp = wall_warp(shell, line, approach_C, 0.5 * gripper.pad.x());
  const double max_warp = kMaxWarpToReach * rim_reach(gripper);
  if (!(warp <= max_warp)) return trials.refuse(Refusal::kTwist);
  const double depth = rim_above(shell, line) - gripper.finger_front;
  const Eigen::Isometry3d X_CG = grasp_pose(line, approach_C, depth);
  if (!on_pads(line, X_CG, gripper)) return trials.refuse(Refusal::kFriction);
  trials.try_hand(
      {line, X_CG, GraspKind::kRim, friction_needed(line), 1.0 - warp / max_warp, {}, false});
}

}  // namespace

TargetGrasps grasps_at_rim(const TargetTask& task) {
  HandTrials trials(task, kMaxChecks, kUsualGrasps);
  std::vector<ContactLine> lines = task.target.rim;
  std::erase_if(lines, [&](const ContactLine& line) {
    const std::optional<Refusal> why = misfit(line, task);
    if (why) trials.refuse(*why);
    return why.has_value();
  });
  ApproachSpace space = approach_space(task);
  space.into_C = -task.target.shell->body.X_CQ.linear().col(2);
  const SampledApproaches sampled = sample_approaches(lines, space);
  trials.refuse(Refusal::kUnreachable, sampled.unreachable);
  trials.refuse(Refusal::kApproach, sampled.unwanted);
  for (const GraspCandidate& candidate : sampled.candidates) {
    if (trials.done()) break;
    try_rim(lines[candidate.line], candidate.approach_C, task, trials);
  }
  return std::move(trials).take();
}

}  // namespace quadrille
