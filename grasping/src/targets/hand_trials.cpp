#include "targets/hand_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "contacts/closing.hpp"
#include "hand/hand.hpp"
#include "hand/reachable_places.hpp"
#include "targets/describe.hpp"
#include "targets/resemblance.hpp"
#include "targets/terms.hpp"

namespace quadrille {
namespace {

// Number of standard deviations in the distance that a pad keeps from the target; it covers 95 % of
// cases.
constexpr double kSigmas = 2.0;
// Upper limit of that part of the distance [m]: where one view tells little, the estimate is seldom
// as wrong as its deviation allows.
constexpr double kMaxDoubt = 0.004;
// Extra opening on either side beyond what a hold needs, in 80ths of the largest opening: wide,
// medium, then none. On the Franka Hand these are 20, 7 and 0 mm. The wider the hand opens, the
// less it matters how well the target's sides are known. 7 mm was the first opening before. With 20
// mm before it, and voxels of supports that give way, 14 of 147 hands touched something on their
// way in, in place of 25 of 147: in 40 simulated packed scenes under the noise of GIGA.
constexpr std::array kRooms = {20, 7, 0};
// A contact is contradicted if space is free at all of these depths below it, in voxels, but no
// deeper than a share of the width.
constexpr double kFreeDepths[] = {-0.5, 0.5, 1.5};
constexpr double kMaxDepthShare = 0.4;

Refusal refusal_of(Obstruction what) {
  switch (what) {
    case Obstruction::kSupport:
      return Refusal::kSupport;
    case Obstruction::kTarget:
      return Refusal::kTarget;
    case Obstruction::kUnknown:
      return Refusal::kUnknown;
    default:
      return Refusal::kCollision;
  }
}

/// Returns the distance that each pad keeps from the target on the way in [m]. The errors of the
/// hand's path and of the target's position are independent, so they add in squares.
/// @param std  standard deviation of half the width between the contacts [m]
double pad_margin(double std, const PlanOptions& options) {
  return std::hypot(options.pad_margin, std::min(kSigmas * std, kMaxDoubt));
}

/// Returns the openings of the hand to be tried, in this order [m].
std::vector<double> preshapes(const ContactLine& line, const TargetTask& task) {
  const double needed = min_opening(line, task.parts.options);
  const double unit = task.parts.gripper.max_opening / 80.0;
  std::vector<double> openings;
  for (const int room : kRooms) {
    const double opening = std::min(needed + 2.0 * (unit * room), task.parts.gripper.max_opening);
    if (std::find(openings.begin(), openings.end(), opening) == openings.end()) {
      openings.push_back(opening);
    }
  }
  return openings;
}

}  // namespace

ApproachSpace approach_space(const TargetTask& task) {
  const Body& body = task.target.body;
  ApproachSpace space;
  space.axes_C = body.X_CQ.linear();
  space.centre_C = body.centre_C();
  space.reach = 0.5 * body.bounds_Q().sizes().maxCoeff();
  const Eigen::Vector3d ray = task.parts.view_of(task.target).p_CV() - space.centre_C;
  if (ray.norm() > 1e-9) space.view_C = ray.normalized();
  // A target may have two supports: the plane that was seen below it, and the one that the robot
  // told. Tips stop above the higher one.
  for (const SupportPlane& plane : task.target.supports) {
    const double height = plane.distance(space.centre_C);
    const double off = std::max(task.scene.margin, plane.flatness());
    if (!(height - off < space.height - space.off_support)) continue;
    space.up_C = plane.n_C();
    space.height = height;
    space.off_support = off;
  }
  space.wanted = task.query.approach;
  return space;
}

double min_opening(const ContactLine& line, const PlanOptions& options) {
  return line.opening + 2.0 * pad_margin(line.std, options);
}

double max_width(double std, const TargetTask& task) {
  return task.parts.gripper.max_opening - 2.0 * pad_margin(std, task.parts.options);
}

std::optional<Refusal> misfit(const ContactLine& line, const TargetTask& task) {
  if (min_opening(line, task.parts.options) <= task.parts.gripper.max_opening &&
      line.width >= task.parts.gripper.min_opening) {
    return std::nullopt;
  }
  return Refusal::kWidth;
}

bool contradicted(const ContactLine& line, const OccupancyGrid& space) {
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d inward = (i == 0 ? -1.0 : 1.0) * line.closing_C;
    const bool all_free =
        std::all_of(std::begin(kFreeDepths), std::end(kFreeDepths), [&](double voxels) {
          const double depth = std::min(voxels * space.resolution(), kMaxDepthShare * line.width);
          return space.at(line.contacts_C[i] + depth * inward) == Voxel::kFree;
        });
    if (all_free) return true;
  }
  return false;
}

HandTrials::HandTrials(const TargetTask& task, int max_checks, std::size_t usual_grasps)
    : task_(task),
      max_checks_(max_checks),
      max_grasps_(std::max(usual_grasps, static_cast<std::size_t>(*task.query.per_target))) {}

bool HandTrials::done() {
  if (checks_ >= max_checks_ || found_.grasps.size() >= max_grasps_) return true;
  found_.cut = task_.deadline.passed();
  return found_.cut;
}

bool HandTrials::resembles_accepted(const ContactLine& line,
                                    const Eigen::Vector3d& approach_C) const {
  return resembles_one_of(found_.grasps, line, approach_C) ||
         resembles_one_of(task_.others, line, approach_C);
}

bool HandTrials::out_of_reach(const Eigen::Isometry3d& X_CG, const Eigen::AlignedBox3d& places_G) {
  const std::optional<Reach>& reach = task_.query.reach;
  if (!reach || may_approach(*reach, X_CG, places_G, task_.parts.options.approach)) return false;
  refuse(Refusal::kReach);
  return true;
}

/// Counts a refusal. Collisions with planes do not count as effort, because they are tested first
/// at little cost.
void HandTrials::obstructed(Refusal why) {
  refuse(why);
  checks_ += why != Refusal::kSupport;
}

bool HandTrials::palm_blocked(const ContactLine& line, const Eigen::Vector3d& approach_C,
                              const Eigen::AlignedBox3d& places_G) {
  const Eigen::Isometry3d X_CG = grasp_pose(line, approach_C, 0.0);
  const auto palm = common_palm(task_.parts.gripper, X_CG, places_G, task_.parts.options.approach);
  const auto what = palm ? task_.scene.palm_obstruction(*palm) : std::nullopt;
  if (what) obstructed(refusal_of(*what));
  return what.has_value();
}

/// Returns why the query does not want a grasp; nullopt if it does. How well its space was seen,
/// and the clearance, take long to measure; they are measured only if the grasp may be wanted.
std::optional<Refusal> HandTrials::unwanted(Grasp& grasp) const {
  const GraspQuery& query = task_.query;
  if (grasp.score < *query.min_score) return Refusal::kScore;
  measure_seen(grasp, task_);
  if (grasp.score < *query.min_score) return Refusal::kScore;
  measure_clearance(grasp, task_);
  if (grasp.clearance < query.min_clearance) return Refusal::kClearance;
  if (grasp.score < *query.min_score) return Refusal::kScore;
  if (query.accept && !query.accept(grasp)) return Refusal::kCaller;
  return std::nullopt;
}

bool HandTrials::is_unlikely(const Attempt& attempt) const {
  return best_score(attempt, task_) < *task_.query.min_score;
}

/// Returns what is in the way of the fingers at the end of the approach, whatever their opening.
std::optional<Obstruction> HandTrials::closing_obstruction(const Attempt& attempt) const {
  const ContactLine& line = attempt.line;
  return task_.scene.closing_obstruction(common_fingers(
      task_.parts.gripper, attempt.X_CG, min_opening(line, task_.parts.options), line.width));
}

/// Returns what is in the way of the palm, and of what is fixed to the hand.
std::optional<Obstruction> HandTrials::back_obstruction(const Attempt& attempt) const {
  const ContactLine& line = attempt.line;
  return task_.scene.back_obstruction(sweep_hand(task_.parts.gripper, attempt.X_CG, line.opening,
                                                 line.width, task_.parts.options.approach,
                                                 task_.attached_G));
}

bool HandTrials::may_succeed(const Attempt& attempt, bool and_palm) const {
  return !is_unlikely(attempt) && !closing_obstruction(attempt) &&
         !(and_palm && back_obstruction(attempt));
}

bool HandTrials::try_hand(const Attempt& attempt) {
  const ContactLine& line = attempt.line;
  if (resembles_accepted(line, attempt.X_CG.linear().col(2))) return true;
  const Eigen::Vector3d here_G = Eigen::Vector3d::Zero();
  if (out_of_reach(attempt.X_CG, Eigen::AlignedBox3d(here_G))) return false;
  if (is_unlikely(attempt)) {
    leave_out_unlikely();
    return false;
  }
  const auto stopped_by = [&](const std::optional<Obstruction>& what) {
    if (what) obstructed(refusal_of(*what));
    return what.has_value();
  };
  if (stopped_by(closing_obstruction(attempt)) || stopped_by(back_obstruction(attempt))) {
    return false;
  }
  if (attempt.may_bulge &&
      meets_too_early(line, attempt.X_CG, task_.parts.gripper, task_.scene.target,
                      pad_margin(line.std, task_.parts.options))) {
    obstructed(Refusal::kTarget);
    return false;
  }
  // A hold counts once, however many openings of the hand were tried.
  const std::optional<Refusal> why = try_openings(attempt);
  if (why) obstructed(*why);
  return !why;
}

std::optional<Refusal> HandTrials::try_openings(const Attempt& attempt) {
  std::optional<Refusal> why;
  for (const double preshape : preshapes(attempt.line, task_)) {
    why = try_opening(attempt, preshape);
    // A narrower opening keeps no farther from a support, and the caller does not want the grasp.
    if (!why || *why == Refusal::kSupport || *why == Refusal::kCaller) break;
  }
  return why;
}

std::optional<Refusal> HandTrials::try_opening(const Attempt& attempt, double preshape) {
  const SweptHand hand = sweep_hand(task_.parts.gripper, attempt.X_CG, preshape, attempt.line.width,
                                    task_.parts.options.approach, task_.attached_G);
  if (const auto what = task_.scene.finger_obstruction(hand)) return refusal_of(*what);
  Grasp grasp = describe(attempt, preshape, task_);
  const std::optional<Refusal> why = unwanted(grasp);
  if (!why) found_.grasps.push_back(std::move(grasp));
  return why;
}

}  // namespace quadrille
