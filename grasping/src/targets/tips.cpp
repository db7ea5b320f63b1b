// Finds holds by the tips alone, wherever they reach, for targets that have no better grasp.
#include <optional>
#include <utility>

#include "contacts/tip_holds.hpp"
#include "targets/hand_trials.hpp"
#include "targets/terms.hpp"

namespace quadrille {
namespace {

// Fits are some millimetres off, by which the normals at the tips turn by some degrees: of 126
// holds in simulated kitchens with less than a fifth of the friction to spare .40 were good, of
// those with more .85.
constexpr double kFrictionShare = 0.8;
// More collision checks than this found hardly any further hold, and hardly any use of a target
// needs more holds than this.
constexpr int kMaxChecks = 4000;
constexpr std::size_t kUsualGrasps = 8;

std::optional<Refusal> unusable(const ContactLine& line, const TargetTask& task) {
  if (const auto why = misfit(line, task)) return why;
  if (contradicted(line, *task.parts.space)) return Refusal::kContradicted;
  return std::nullopt;
}

Attempt tip_attempt(const Hold& hold) {
  return {hold.line, grasp_pose(hold.line, hold.approach_C, 0.0), GraspKind::kTip, hold.friction};
}

/// Returns true if a hold is likely enough to be tried. Of 139 targets in simulated scenes those on
/// which half of the orientations gave no such hold took nine tenths of the work, and none of them
/// was among the 9 that were held by the tips. A third is not enough: in other scenes a grasp with
/// a score of .93 was lost.
bool is_worth_a_trial(const Hold& hold, const TargetTask& task) {
  return !unusable(hold.line, task) && best_score(tip_attempt(hold), task) >= *task.query.min_score;
}

/// Returns the greatest distance between the contacts of a hold with this closing direction [m]; 0
/// if the target's width along it is so uncertain that no hold would score enough.
double widest_hold(const Eigen::Vector3d& closing_C, const TargetTask& task, HandTrials& trials) {
  // Far more than what rounding changes in widths of some centimetres [m].
  constexpr double kRounding = 1e-6;
  const Body& body = task.target.body;
  const double std = body.least_width_std(body.X_CQ.linear().transpose() * closing_C);
  if (best_shape_score(std, task) >= *task.query.min_score) return max_width(std, task) + kRounding;
  trials.leave_out_unlikely();
  return 0.0;
}

}  // namespace

TargetGrasps grasps_by_tips(const TargetTask& task) {
  HandTrials trials(task, kMaxChecks, kUsualGrasps);
  const TipLimits limits{task.scene,
                         task.parts.options.approach,
                         kFrictionShare * task.parts.options.friction,
                         [&](const Eigen::Isometry3d& X_CG, const Eigen::AlignedBox3d& places_G) {
                           return trials.out_of_reach(X_CG, places_G);
                         },
                         [&](const Eigen::Vector3d& d) { return widest_hold(d, task, trials); },
                         [&](const Hold& hold) { return is_worth_a_trial(hold, task); }};
  for (const Hold& hold :
       tip_holds(task.target.body, task.parts.gripper, approach_space(task), limits)) {
    if (trials.done()) break;
    if (const auto why = unusable(hold.line, task)) {
      trials.refuse(*why);
      continue;
    }
    trials.try_hand(tip_attempt(hold));
  }
  return std::move(trials).take();
}

}  // namespace quadrille
