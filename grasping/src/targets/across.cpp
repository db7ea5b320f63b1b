// Grasps across the widest part of a body, or a little before it, where only the tips hold.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "contacts/box_lines.hpp"
#include "contacts/closing.hpp"
#include "contacts/quality.hpp"
#include "targets/hand_trials.hpp"

namespace quadrille {
namespace {

// Effort per target. The candidates come best first, so more of it finds little.
constexpr int kMaxChecks = 4000;
constexpr std::size_t kMaxGrasps = 12;
// A contact close to slipping in the model slips in truth: normals are known to a few degrees.
constexpr double kFrictionShare = 0.85;
// How far before the widest part, towards the hand, chords of the body are tried, as a share of
// half the width. A ball needs a friction coefficient of 0.36/√(1 − 0.36²) = 0.39 on the farthest
// one, of the 0.85 · 0.5 that there are by default.
constexpr double kMaxChordOffset = 0.36;
constexpr double kChordOffsets[] = {0.2, kMaxChordOffset, 0.1, 0.28};
// The least share of the greatest width that these chords are long: on a ball the farthest has a
// share of 0.93, on bodies that narrow faster less.
constexpr double kMinChordShare = 0.88;
// From one depth along the pads that is tried to the next, as a share of their length.
constexpr double kDepthStepToPad = 0.33;
// How far the tips reach beyond a contact that only they hold [m]: their rounding, and the doubt
// about where the contact is.
constexpr double kTipBeyond = 0.003;
// Cosine between a closing direction and an axis that runs along it: of lines across it is 0.
constexpr double kMinAlongAxis = 0.7;

std::optional<Refusal> unusable(const ContactLine& line, const TargetTask& task) {
  if (const auto why = misfit(line, task)) return why;
  if (friction_needed(line) > kFrictionShare * task.options.friction) return Refusal::kFriction;
  if (contradicted(line, task.space)) return Refusal::kContradicted;
  return std::nullopt;
}

/// All of the target's kind.
std::vector<ContactLine> lines_across(const TargetTask& task, const ApproachSpace& space,
                                      HandTrials& trials) {
  if (!task.target.box) {
    return contact_lines(task.target.body, task.gripper, task.viewpoint_C, space.up_C);
  }
  BoxLines found = box_lines(*task.target.box, task.gripper);
  trials.refuse(Refusal::kUnmeasured, found.unmeasured);
  return std::move(found.lines);
}

/// The lines across which the hand fits, there or at a chord before them.
std::vector<ContactLine> usable_lines(const TargetTask& task, const ApproachSpace& space,
                                      HandTrials& trials) {
  std::vector<ContactLine> lines = lines_across(task, space, trials);
  std::erase_if(lines, [&](const ContactLine& line) {
    ContactLine narrowed = line;
    // A box is as wide before its middle as there.
    if (!task.target.box) narrowed.opening *= kMinChordShare;
    const std::optional<Refusal> why = unusable(narrowed, task);
    if (why) trials.refuse(*why);
    return why.has_value();
  });
  return lines;
}

/// Where a hand is moved from a line by all that is tried here, along the axes of G.
Eigen::AlignedBox3d places(const ContactLine& line, const Gripper& gripper) {
  const double step = kDepthStepToPad * gripper.pad.y();
  const double back = kMaxChordOffset * 0.5 * line.width + gripper.finger_front;
  // The middle of a chord beside the line lies no farther to the side than the line's ends.
  const Eigen::Vector3d slack(0.0, 0.5 * line.width, 0.0);
  return {Eigen::Vector3d(0.0, 0.0, -std::max(back, step)) - slack,
          Eigen::Vector3d(0.0, 0.0, step) + slack};
}

/// Only cylinders and slabs are held at their ends.
GraspKind kind_of(const ContactLine& line, const Target& target) {
  const Body::Profile profile = target.body.profile;
  const bool has_ends = profile == Body::Profile::kConstant || profile == Body::Profile::kBox;
  const double along = std::abs(line.closing_C.dot(target.body.X_CQ.linear().col(2)));
  return has_ends && !target.box && along > kMinAlongAxis ? GraspKind::kEnd : GraspKind::kAcross;
}

bool try_depth(const ContactLine& line, const Eigen::Vector3d& approach_C, double depth,
               GraspKind kind, const TargetTask& task, HandTrials& trials) {
  const Eigen::Isometry3d X_CG = grasp_pose(line, approach_C, depth);
  if (on_pads(line, X_CG, task.gripper)) {
    return trials.try_hand({line, X_CG, kind, friction_needed(line)});
  }
  trials.refuse(Refusal::kFriction);
  return false;
}

/// The widest part that the tips pass if they hold the body `off` before the line [m].
double passed_by_tips(const ContactLine& line, double off, const Eigen::Vector3d& approach_C,
                      const Body& body) {
  if (off <= kTipBeyond) return line.opening;
  const Eigen::Vector3d tips_C = line.centre_C - (off - kTipBeyond) * approach_C;
  const std::optional<ContactLine> passed = chord(body, tips_C, line.closing_C);
  return passed ? passed->width : line.opening;
}

/// Before the widest part, with the tips: what lies low, or in front of unseen space, can still be
/// held as far as friction allows.
void try_chords(const ContactLine& line, const Eigen::Vector3d& approach_C, const TargetTask& task,
                HandTrials& trials) {
  const Body& body = task.target.body;
  const double depth = kTipBeyond - task.gripper.finger_front;
  for (const double share : kChordOffsets) {
    const double off = 0.5 * share * line.width;
    const Eigen::Vector3d p_C = line.centre_C - off * approach_C;
    std::optional<ContactLine> before = chord(body, p_C, line.closing_C);
    if (!before || lopsided(*before, approach_C)) continue;
    before->opening = std::max(before->width, passed_by_tips(line, off, approach_C, body));
    before->std = line.std;
    if (const auto why = unusable(*before, task)) {
      trials.refuse(*why);
    } else if (try_depth(*before, approach_C, depth, GraspKind::kTip, task, trials)) {
      return;
    }
  }
}

/// Most candidates end at palm_blocked(), at the cost of one check.
void try_across(const ContactLine& line, const Eigen::Vector3d& approach_C, const TargetTask& task,
                HandTrials& trials) {
  if (trials.resembles_accepted(line, approach_C) ||
      trials.palm_blocked(line, approach_C, places(line, task.gripper))) {
    return;
  }
  if (min_opening(line, task.options) <= task.gripper.max_opening) {
    const double step = kDepthStepToPad * task.gripper.pad.y();
    const GraspKind kind = kind_of(line, task.target);
    for (const double depth : {0.0, -step, step}) {
      if (try_depth(line, approach_C, depth, kind, task, trials)) return;
    }
  }
  try_chords(line, approach_C, task, trials);
}

}  // namespace

TargetGrasps grasps_across(const TargetTask& task) {
  HandTrials trials(task, kMaxChecks, kMaxGrasps);
  const ApproachSpace space = approach_space(task);
  const std::vector<ContactLine> lines = usable_lines(task, space, trials);
  const SampledApproaches sampled = sample_approaches(lines, space);
  trials.refuse(Refusal::kUnreachable, sampled.unreachable);
  trials.refuse(Refusal::kApproach, sampled.unwanted);
  for (const GraspCandidate& candidate : sampled.candidates) {
    if (trials.done()) break;
    try_across(lines[candidate.line], candidate.approach_C, task, trials);
  }
  return trials.take();
}

}  // namespace quadrille
