// What only the tips hold: above the widest part, or where nothing better is to be had.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "contacts/closing.hpp"
#include "target_planner.hpp"

namespace quadrille {

namespace {

// Holds by the tips are exact: their normals are those of the very place, so that less is kept in
// hand than for contacts that the pads smooth out.
constexpr double kTipFrictionShare = 0.9;
// More collision checks than this found hardly any further hold, and more holds than this are not
// needed of a target.
constexpr int kMaxTipChecks = 4000;
constexpr std::size_t kMaxTipHolds = 8;
// How far the tips reach beyond a contact that only they hold [m]: their rounding, and the doubt
// about where the contact is.
constexpr double kTipBeyond = 0.003;

}  // namespace

// The widest part that the tips pass if they hold the body `off` before the line.
double TargetPlanner::passed_by_tips(const ContactLine& line, double off,
                                     const Eigen::Vector3d& approach_C) const {
  if (off <= kTipBeyond) return line.opening;
  const Eigen::Vector3d tips_C = line.centre_C - (off - kTipBeyond) * approach_C;
  const std::optional<ContactLine> passed = chord(target_.body, tips_C, line.closing_C);
  return passed ? passed->width : line.opening;
}

// Above the widest part, with the tips: what lies low, or in front of unseen space, can still be
// held as far as friction allows.
bool TargetPlanner::try_chords(const ContactLine& line, const Eigen::Vector3d& approach_C,
                               Counts& rejected) {
  const double depth = kTipBeyond - gripper_.finger_front;
  for (const double share : {0.2, kMaxBeside, 0.1, 0.28}) {
    const double off = 0.5 * share * line.width;
    const Eigen::Vector3d p_C = line.centre_C - off * approach_C;
    std::optional<ContactLine> beside = chord(target_.body, p_C, line.closing_C);
    if (!beside || lopsided(*beside, approach_C)) continue;
    beside->opening = std::max(beside->width, passed_by_tips(line, off, approach_C));
    beside->std = line.std;
    if (usable(*beside, rejected) && try_depth(*beside, approach_C, depth, rejected)) return true;
  }
  return false;
}

std::vector<Grasp> TargetPlanner::plan_tips(const Eigen::Vector3d& viewpoint_C, Counts& rejected) {
  const double friction = kTipFrictionShare * options_.friction;
  const std::vector<TipHold> holds = tip_holds(target_.body, gripper_, approach_space(viewpoint_C),
                                               {scene_, options_.approach, friction});
  for (const TipHold& hold : holds) {
    if (checks_ >= kMaxTipChecks || accepted_.size() >= kMaxTipHolds) break;
    if (!fits(hold.line, rejected)) continue;
    if (contradicted(hold.line)) {
      ++rejected["contradicted"];
      continue;
    }
    const Eigen::Isometry3d X_CG = grasp_pose(hold.line, hold.approach_C, 0.0);
    try_hand({hold.line, X_CG, hold.friction}, rejected);
  }
  return std::move(accepted_);
}

}  // namespace quadrille
