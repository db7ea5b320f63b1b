#include "target_planner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contacts/closing.hpp"
#include "contacts/quality.hpp"
#include "contacts/wall_hold.hpp"

namespace quadrille {

namespace {

// Effort per target. The candidates come best first, so more of it finds little.
constexpr int kMaxChecks = 4000;
constexpr std::size_t kMaxAccepted = 12;
// Grasps nearer than this to an accepted one add nothing.
constexpr double kNearby = 0.012;
const double kAlike = std::cos(20.0 * std::numbers::pi / 180.0);
// A contact close to slipping in the model slips in truth: normals are known to a few degrees.
constexpr double kFrictionShare = 0.85;
// Standard deviations of a pad's distance to keep from the target: 95 % of truths.
constexpr double kSigmas = 2.0;
// But no more than this [m]: what one view tells little of is seldom as wrong as it may be.
constexpr double kMaxDoubt = 0.004;
// The least share of a body's greatest width that its chords beside the widest part are long: the
// farthest lie kMaxBeside off, where a ball is 0.93 as wide, and others narrow faster.
constexpr double kNarrowest = 0.88;
// Walls that are warped more under the pads turn in the hand [m]: on a pad 9 mm to either side,
// that is 4° out of line, of the 5° that a held object may turn.
constexpr double kMaxWarp = 0.0006;

Eigen::Vector3d middle(const std::array<Eigen::Vector3d, 2>& contacts_C) {
  return 0.5 * (contacts_C[0] + contacts_C[1]);
}

std::string reason(Obstruction what) {
  switch (what) {
    case Obstruction::kSupport:
      return "support";
    case Obstruction::kTarget:
      return "target";
    case Obstruction::kUnknown:
      return "unknown";
    default:
      return "collision";
  }
}

}  // namespace

double TargetPlanner::margin(const ContactLine& line) const {
  return options_.pad_margin + std::min(kSigmas * line.std, kMaxDoubt);
}

double TargetPlanner::min_opening(const ContactLine& line) const {
  return line.opening + 2.0 * margin(line);
}

ApproachSpace TargetPlanner::approach_space(const Eigen::Vector3d& viewpoint_C) const {
  ApproachSpace space;
  space.axes_C = target_.body.X_CQ.linear();
  space.centre_C = target_.body.centre_C();
  space.reach = 0.5 * target_.body.bounds_Q().sizes().maxCoeff();
  const Eigen::Vector3d ray = viewpoint_C - space.centre_C;
  if (ray.norm() > 1e-9) space.view_C = ray.normalized();
  if (!target_.supports.empty()) space.up_C = target_.supports.front().n_C();
  return space;
}

std::vector<Grasp> TargetPlanner::plan(const Eigen::Vector3d& viewpoint_C, Counts& rejected) {
  const ApproachSpace space = approach_space(viewpoint_C);
  std::vector<ContactLine> lines = contact_lines(target_.body, gripper_, viewpoint_C, space.up_C);
  std::erase_if(lines, [&](const ContactLine& line) { return !usable(narrowed(line), rejected); });
  int refused = 0;
  const std::vector<GraspCandidate> candidates = sample_approaches(lines, space, refused);
  if (refused > 0) rejected["unreachable"] += refused;
  for (const GraspCandidate& candidate : candidates) {
    if (checks_ >= kMaxChecks || accepted_.size() >= kMaxAccepted) break;
    try_across(lines[candidate.line], candidate.approach_C, rejected);
  }
  return std::move(accepted_);
}

std::vector<Grasp> TargetPlanner::plan_rim(const Eigen::Vector3d& viewpoint_C, Counts& rejected) {
  std::vector<ContactLine> lines = target_.rim;
  std::erase_if(lines, [&](const ContactLine& line) { return !fits(line, rejected); });
  ApproachSpace space = approach_space(viewpoint_C);
  space.into_C = -target_.shell->body.X_CQ.linear().col(2);
  int refused = 0;
  const std::vector<GraspCandidate> candidates = sample_approaches(lines, space, refused);
  if (refused > 0) rejected["unreachable"] += refused;
  for (const GraspCandidate& candidate : candidates) {
    if (checks_ >= kMaxChecks || accepted_.size() >= kMaxAccepted) break;
    try_rim(lines[candidate.line], candidate.approach_C, rejected);
  }
  return std::move(accepted_);
}

// False, and counted, if the hand does not open as far or close as far.
bool TargetPlanner::fits(const ContactLine& line, Counts& rejected) const {
  if (min_opening(line) <= gripper_.max_opening && line.width >= gripper_.min_opening) {
    return true;
  }
  ++rejected["width"];
  return false;
}

bool TargetPlanner::usable(const ContactLine& line, Counts& rejected) const {
  const auto refuse = [&](const char* why) {
    ++rejected[why];
    return false;
  };
  if (!fits(line, rejected)) return false;
  if (friction_needed(line) > kFrictionShare * options_.friction) return refuse("friction");
  if (contradicted(line)) return refuse("contradicted");
  return true;
}

// The line, opened as far as the body may need beside its widest part.
ContactLine TargetPlanner::narrowed(ContactLine line) const {
  line.opening *= kNarrowest;
  return line;
}

bool TargetPlanner::contradicted(const ContactLine& line) const {
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d inward = (i == 0 ? -1.0 : 1.0) * line.closing_C;
    bool all_free = true;
    for (const double steps : {-0.5, 0.5, 1.5}) {
      const double depth = std::min(steps * grid_.resolution(), 0.4 * line.width);
      all_free &= grid_.at(line.contacts_C[i] + depth * inward) == Voxel::kFree;
    }
    if (all_free) return true;
  }
  return false;
}

bool TargetPlanner::observed(const Eigen::Vector3d& contact_C) const {
  const double step = grid_.resolution();
  for (int n = 0; n < 27; ++n) {
    const Eigen::Vector3d offset(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    if (grid_.at(contact_C + step * offset) == Voxel::kOccupied) return true;
  }
  return false;
}

bool TargetPlanner::resembles_accepted(const ContactLine& line,
                                       const Eigen::Vector3d& approach_C) const {
  const Eigen::Vector3d here = middle(line.contacts_C);
  return std::any_of(accepted_.begin(), accepted_.end(), [&](const Grasp& other) {
    return (middle(other.contacts_C) - here).norm() < kNearby &&
           other.X_CG.linear().col(2).dot(approach_C) > kAlike &&
           std::abs(other.X_CG.linear().col(1).dot(line.closing_C)) > kAlike;
  });
}

// Medium, wide, then narrow.
std::vector<double> TargetPlanner::preshapes(const ContactLine& line) const {
  std::vector<double> openings;
  const double least = min_opening(line);
  for (const double room : {0.007, 0.014, 0.0}) {
    const double opening = std::min(least + 2.0 * room, gripper_.max_opening);
    if (std::find(openings.begin(), openings.end(), opening) == openings.end()) {
      openings.push_back(opening);
    }
  }
  return openings;
}

// True, and counted, if the palm is in the way of something at whichever depth, chords included:
// most candidates end here, at the cost of one check.
bool TargetPlanner::blocked(const ContactLine& line, const Eigen::Vector3d& approach_C,
                            Counts& rejected) {
  const double step = depth_step(), back = kMaxBeside * 0.5 * line.width + gripper_.finger_front;
  // The middle of a chord beside the line lies no farther to the side than the line's ends.
  const Eigen::Vector3d slack(0.0, 0.5 * line.width, 0.0);
  const Eigen::AlignedBox3d places_G(Eigen::Vector3d(0.0, 0.0, -std::max(back, step)) - slack,
                                     Eigen::Vector3d(0.0, 0.0, step) + slack);
  const Eigen::Isometry3d X_CG = grasp_pose(line, approach_C, 0.0);
  const auto palm = common_palm(gripper_, X_CG, places_G, options_.approach);
  const auto what = palm ? scene_.palm_obstruction(*palm) : std::nullopt;
  if (what) refuse(*what, rejected);
  return what.has_value();
}

void TargetPlanner::try_across(const ContactLine& line, const Eigen::Vector3d& approach_C,
                               Counts& rejected) {
  if (resembles_accepted(line, approach_C) || blocked(line, approach_C, rejected)) return;
  if (min_opening(line) <= gripper_.max_opening) {
    const double step = depth_step();
    for (const double depth : {0.0, -step, step}) {
      if (try_depth(line, approach_C, depth, rejected)) return;
    }
  }
  try_chords(line, approach_C, rejected);
}

// The tips as far beyond the contacts as the rim is before them: the bend of the wall then turns it
// neither way.
void TargetPlanner::try_rim(const ContactLine& line, const Eigen::Vector3d& approach_C,
                            Counts& rejected) {
  const Shell& shell = *target_.shell;
  const double warp = wall_warp(shell, line, approach_C, 0.5 * gripper_.pad.x());
  if (!(warp <= kMaxWarp)) {
    ++rejected["twist"];
    return;
  }
  const double depth = rim_above(shell, line) - gripper_.finger_front;
  const Eigen::Isometry3d X_CG = grasp_pose(line, approach_C, depth);
  if (on_pads(line, X_CG, gripper_)) {
    try_hand({line, X_CG, friction_needed(line), 1.0 - warp / kMaxWarp, false}, rejected);
  } else {
    ++rejected["friction"];
  }
}

bool TargetPlanner::try_depth(const ContactLine& line, const Eigen::Vector3d& approach_C,
                              double depth, Counts& rejected) {
  const Eigen::Isometry3d X_CG = grasp_pose(line, approach_C, depth);
  if (on_pads(line, X_CG, gripper_)) {
    return try_hand({line, X_CG, friction_needed(line)}, rejected);
  }
  ++rejected["friction"];
  return false;
}

// Planes are looked at first, at little cost: they do not count as effort.
void TargetPlanner::refuse(Obstruction what, Counts& rejected) {
  ++rejected[reason(what)];
  checks_ += what != Obstruction::kSupport;
}

// True if there is now a grasp like this, so that none like it need be tried.
bool TargetPlanner::try_hand(const Attempt& attempt, Counts& rejected) {
  const ContactLine& line = attempt.line;
  if (resembles_accepted(line, attempt.X_CG.linear().col(2))) return true;
  const auto swept = [&](double preshape) {
    return sweep_hand(gripper_, attempt.X_CG, preshape, line.width, options_.approach);
  };
  const auto refused = [&](const std::optional<Obstruction>& what) {
    if (what) refuse(*what, rejected);
    return what.has_value();
  };
  const auto fingers = common_fingers(gripper_, attempt.X_CG, min_opening(line), line.width);
  if (refused(scene_.closing_obstruction(fingers))) return false;
  if (refused(scene_.palm_obstruction(swept(line.opening).palm))) return false;
  if (attempt.may_bulge &&
      meets_too_early(line, attempt.X_CG, gripper_, scene_.target, margin(line))) {
    refuse(Obstruction::kTarget, rejected);
    return false;
  }
  for (const double preshape : preshapes(line)) {
    const std::optional<Obstruction> what = scene_.finger_obstruction(swept(preshape));
    if (!what) {
      accepted_.push_back(describe(attempt, preshape));
      return true;
    }
    refuse(*what, rejected);
    if (*what == Obstruction::kSupport) return false;  // another opening does not help
  }
  return false;
}

Grasp TargetPlanner::describe(const Attempt& attempt, double preshape) const {
  Grasp grasp;
  grasp.target = target_.id;
  grasp.X_CG = attempt.X_CG;
  grasp.width = attempt.line.width;
  grasp.preshape = preshape;
  grasp.contacts_C = attempt.line.contacts_C;
  grasp.approach = options_.approach;
  grasp.friction_needed = attempt.friction;
  rate(grasp, attempt);
  return grasp;
}

void TargetPlanner::rate(Grasp& grasp, const Attempt& attempt) const {
  const ContactLine& line = attempt.line;
  const double reach = 0.5 * target_.body.bounds_Q().sizes().maxCoeff();
  ContactModel model;
  model.friction = options_.friction;
  // A pad of soft material touches on a disc of about half its size: γ = 2/3 μ r.
  model.torsion = 2.0 / 3.0 * options_.friction * 0.25 * gripper_.pad.minCoeff();
  model.torque_scale = reach;
  grasp.epsilon = grasp_epsilon(line, model);
  grasp.clearance = scene_.clearance(
      sweep_hand(gripper_, grasp.X_CG, grasp.preshape, grasp.width, grasp.approach));
  const int seen = observed(line.contacts_C[0]) + observed(line.contacts_C[1]);
  grasp.unknown_contact = seen < 2;
  ScoreTerms terms;
  terms.friction = (1.0 - grasp.friction_needed / options_.friction) * attempt.straight;
  terms.clearance = grasp.clearance / 0.01;
  terms.observed = 0.5 * seen;
  terms.room = 0.5 * (grasp.preshape - line.opening) / 0.005;
  terms.central = 1.0 - (line.centre_C - target_.body.centre_C()).norm() / reach;
  grasp.score = grasp_score(terms) * (0.5 + 0.5 * std::clamp(target_.confidence, 0.0, 1.0));
}

}  // namespace quadrille
