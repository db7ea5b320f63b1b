// Finds grasps across the widest part of a body, or slightly in front of it, where only the tips
// hold.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "contacts/box_lines.hpp"
#include "contacts/closing.hpp"
#include "contacts/quality.hpp"
#include "targets/hand_trials.hpp"
#include "targets/terms.hpp"

namespace quadrille {
namespace {

// Limits on the effort per target. Candidates come best first, so higher limits would find little
// more.
constexpr int kMaxChecks = 4000;
constexpr std::size_t kUsualGrasps = 12;
// A contact that is close to slipping in the model may slip in truth, since normals are known only
// to a few degrees.
constexpr double kFrictionShare = 0.85;
// Distances in front of the widest part, towards the hand, at which chords of the body are tried,
// as a share of half the width. On the farthest, a ball needs a friction coefficient of
//   0.36/√(1 − 0.36²) = 0.39, out of the 0.85 · 0.5 available by default.
constexpr double kMaxChordOffset = 0.36;
constexpr double kChordOffsets[] = {0.2, kMaxChordOffset, 0.1, 0.28};
// Least length of these chords, as a share of the greatest width. On a ball the farthest chord has
// a share of 0.93, and less on bodies that narrow faster.
constexpr double kMinChordShare = 0.88;
// Distance between neighbouring depths along the pads that are tried, as a share of the pad's
// length.
constexpr double kDepthStepToPad = 0.33;
// Distance that the tips reach beyond a contact that only they hold [m]: for their rounding, and
// for the uncertainty of the contact.
constexpr double kTipBeyond = 0.003;
// Least cosine between a closing direction and the axis for a grasp at the ends; for lines across
// the axis it is 0.
constexpr double kMinAlongAxis = 0.7;

std::optional<Refusal> unusable(const ContactLine& line, const TargetTask& task) {
  if (const auto why = misfit(line, task)) return why;
  if (doubted_friction(line) > kFrictionShare * task.parts.options.friction)
    return Refusal::kFriction;
  if (contradicted(line, *task.parts.space)) return Refusal::kContradicted;
  return std::nullopt;
}

/// Returns all contact lines for the target's kind of shape.
std::vector<ContactLine> lines_across(const TargetTask& task, const ApproachSpace& space,
                                      HandTrials& trials) {
  if (!task.target.box) {
    return contact_lines(task.target.body, task.parts.gripper,
                         task.parts.view_of(task.target).p_CV(), space.up_C);
  }
  BoxLines found = box_lines(*task.target.box, task.parts.gripper);
  trials.refuse(Refusal::kUnmeasured, found.unmeasured);
  return std::move(found.lines);
}

/// Returns the lines across which the hand fits, at the line itself or at a chord in front of it.
std::vector<ContactLine> usable_lines(const TargetTask& task, const ApproachSpace& space,
                                      HandTrials& trials) {
  std::vector<ContactLine> lines = lines_across(task, space, trials);
  std::erase_if(lines, [&](const ContactLine& line) {
    ContactLine narrowed = line;
    // A box is as wide in front of its middle as at it.
    if (!task.target.box) narrowed.opening *= kMinChordShare;
    const std::optional<Refusal> why = unusable(narrowed, task);
    if (why) trials.refuse(*why);
    const bool unlikely = !why && best_shape_score(line.std, task) < *task.query.min_score;
    if (unlikely) trials.leave_out_unlikely();
    return why || unlikely;
  });
  return lines;
}

/// Returns the bounds of all displacements from a line that are tried here, along the axes of G.
Eigen::AlignedBox3d places(const ContactLine& line, const Gripper& gripper) {
  const double step = kDepthStepToPad * gripper.pad.y();
  const double back = kMaxChordOffset * 0.5 * line.width + gripper.finger_front;
  // The middle of a chord beside the line lies no farther to the side than the line's ends.
  const Eigen::Vector3d slack(0.0, 0.5 * line.width, 0.0);
  return {Eigen::Vector3d(0.0, 0.0, -std::max(back, step)) - slack,
          Eigen::Vector3d(0.0, 0.0, step) + slack};
}

/// Tells how a line holds the target; only cylinders and slabs are held at their ends.
GraspKind kind_of(const ContactLine& line, const Target& target) {
  const Body::Profile profile = target.body.profile;
  const bool has_ends = profile == Body::Profile::kConstant || profile == Body::Profile::kBox;
  const double along = std::abs(line.closing_C.dot(target.body.X_CQ.linear().col(2)));
  return has_ends && !target.box && along > kMinAlongAxis ? GraspKind::kEnd : GraspKind::kAcross;
}

bool try_depth(const ContactLine& line, const Eigen::Vector3d& approach_C, double depth,
               GraspKind kind, const TargetTask& task, HandTrials& trials) {
  const Eigen::Isometry3d X_CG = grasp_pose(line, approach_C, depth);
  if (on_pads(line, X_CG, task.parts.gripper)) {
    return trials.try_hand({line, X_CG, kind, friction_needed(line)});
  }
  trials.refuse(Refusal::kFriction);
  return false;
}

/// Returns the greatest width that the tips pass if they hold the body at a distance `off` in front
/// of the line [m].
double passed_by_tips(const ContactLine& line, double off, const Eigen::Vector3d& approach_C,
                      const Body& body) {
  if (off <= kTipBeyond) return line.opening;
  const Eigen::Vector3d tips_C = line.centre_C - (off - kTipBeyond) * approach_C;
  const std::optional<ContactLine> passed = chord(body, tips_C, line.closing_C);
  return passed ? passed->width : line.opening;
}

/// Tries to hold the body with the tips in front of its widest part. This way, objects that lie low
/// or in front of unseen space can still be held as far as friction allows.
void try_chords(const ContactLine& line, const Eigen::Vector3d& approach_C, const TargetTask& task,
                HandTrials& trials) {
  const Body& body = task.target.body;
  const double depth = kTipBeyond - task.parts.gripper.finger_front;
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

/// Tries the hand at one line and approach. Most candidates already fail at palm_blocked(), which
/// costs only one check.
void try_across(const ContactLine& line, const Eigen::Vector3d& approach_C, const TargetTask& task,
                HandTrials& trials) {
  const Eigen::AlignedBox3d places_G = places(line, task.parts.gripper);
  if (trials.resembles_accepted(line, approach_C) ||
      trials.out_of_reach(grasp_pose(line, approach_C, 0.0), places_G) ||
      trials.palm_blocked(line, approach_C, places_G)) {
    return;
  }
  if (min_opening(line, task.parts.options) <= task.parts.gripper.max_opening) {
    const double step = kDepthStepToPad * task.parts.gripper.pad.y();
    const GraspKind kind = kind_of(line, task.target);
    for (const double depth : {0.0, -step, step}) {
      if (try_depth(line, approach_C, depth, kind, task, trials)) return;
    }
  }
  try_chords(line, approach_C, task, trials);
}

}  // namespace

TargetGrasps grasps_across(const TargetTask& task) {
  HandTrials trials(task, kMaxChecks, kUsualGrasps);
  const ApproachSpace space = approach_space(task);
  const std::vector<ContactLine> lines = usable_lines(task, space, trials);
  const SampledApproaches sampled = sample_approaches(lines, space);
  trials.refuse(Refusal::kUnreachable, sampled.unreachable);
  trials.refuse(Refusal::kApproach, sampled.unwanted);
  for (const GraspCandidate& candidate : sampled.candidates) {
    if (trials.done()) break;
    try_across(lines[candidate.line], candidate.approach_C, task, trials);
  }
  return std::move(trials).take();
}

}  // namespace quadrille
