// Says how likely further views give grasps to bodies without a sure one. The numbers were measured
// on twelve simulated kitchens under stereo and six crowded scenes with the noise of depth cameras:
// what a plan said of 160 such bodies in one view was compared with what it said once one more view
// was added, out of four to seven from all sides. To measure them again, render such scenes from
// the first place and from others around them, plan on the first view alone and on it with each
// other view (`--view`), and count the bodies without a sure grasp that get one in the second plan.
// The counts by refusal are the shares below, and a logistic fit to all pairs of a body and a view
// gives the log odds.
#include "scene/view_chance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace quadrille {
namespace {

// Bodies whose best grasp has this score need no further view.
constexpr double kSureScore = 0.9;
// Sizes are known to so many standard deviations; this covers 95 % of cases.
constexpr double kSigmas = 2.0;
// A body is upright along the axes that are nearer to the vertical than 45°. The hand cannot close
// along these, since one finger would have to be below the body.
constexpr double kUpright = std::numbers::sqrt2 / 2.0;

// Shares of bodies that got a grasp by at least one view, by what refused the candidates that got
// furthest. Most hands that meet things meet the body itself where its fit is poor, or another fit
// to the same thing, and a second view corrects that: it did so for 12 of 16 bodies. It seldom does
// if the body is too wide for the hand or mostly too low for it: by a quarter of all views, in
// place of half of them.
constexpr double kMetThings = 0.8, kMetThingsAndMore = 0.4;
// If unknown space is an obstacle, and hands met nothing else, this share of the bodies is taken to
// get a grasp by some view. With it, 26 of 40 bodies were expected to get one by the view that was
// proposed, and 26 did.
constexpr double kMetUnknown = 0.8;
// All candidates of 58 bodies had too low a score, and 24 of these bodies got a grasp by some view.
// Many of the others are strays of the sensor. The support was in the way of the hand at 18 bodies,
// and 3 of them got a grasp.
constexpr double kLowScore = 0.35, kMetSupport = 0.15;
// Bodies whose rim or side was not seen were too few to measure their share, which is assumed.
constexpr double kNotSeen = 0.5;
// These are the shares of bodies with a grasp that a view is to make sure. From this score on views
// did so for 7 of 8; below it they did so for 21 of 25, but few views of each, so that a view is
// worth less there.
constexpr double kNearlySureScore = 0.82, kNearlySure = 0.9, kUnsure = 0.55;

// Log odds that a view gives a body a grasp which some view gives: with none of the unknown space,
// from the same direction and along the support; how much they grow with the share that is seen up
// to a half, with the angle between the views up to 60°, and with the sine of the angle to the
// support up to 40°. A view of more than that shows another side, and is of no more help. They were
// fitted to 234 pairs of a body and a view.
constexpr double kNoChange = -3.0, kByShare = 1.9, kByAngle = 1.9, kByHeight = 0.7;
constexpr double kEnoughShare = 0.5, kEnoughAngle = std::numbers::pi / 3.0, kEnoughHeight = 0.64;
// To make a doubtful grasp sure is harder.
constexpr double kHarder = 0.6;

bool is_of(int target, const SceneBody& body) {
  return target == body.id ||
         std::find(body.parts.begin(), body.parts.end(), target) != body.parts.end();
}

/// Returns the best score of a body's grasps; 0 if it has none.
double best_score(const GraspPlan& plan, const SceneBody& body) {
  double best = 0.0;
  for (const Grasp& grasp : plan.grasps) {
    if (is_of(grasp.target, body)) best = std::max(best, grasp.score);
  }
  return best;
}

/// Returns the refused candidates of all parts of a body.
RefusalCounts refusals_of(const GraspPlan& plan, const SceneBody& body) {
  RefusalCounts all;
  for (const TargetOutcome& outcome : plan.targets) {
    if (!is_of(outcome.target, body)) continue;
    for (const auto& [why, count] : outcome.refusals) all[why] += count;
  }
  return all;
}

int count_of(const RefusalCounts& refusals, Refusal why) {
  const auto found = refusals.find(why);
  return found == refusals.end() ? 0 : found->second;
}

/// Returns true if the support was in the way of more candidates than things were.
bool mostly_meets_support(const RefusalCounts& refusals) {
  return count_of(refusals, Refusal::kSupport) > count_of(refusals, Refusal::kContradicted) +
                                                     count_of(refusals, Refusal::kTarget) +
                                                     count_of(refusals, Refusal::kCollision);
}

/// Returns the chance of a body without a grasp.
double chance_without_grasp(const RefusalCounts& refusals, bool fits) {
  const std::optional<Refusal> why = furthest(refusals);
  if (!why) return 0.0;
  switch (*why) {
    case Refusal::kContradicted:
    case Refusal::kTarget:
    case Refusal::kCollision:
      return fits && !mostly_meets_support(refusals) ? kMetThings : kMetThingsAndMore;
    case Refusal::kUnknown:
      return kMetUnknown;
    case Refusal::kNoShape:
    case Refusal::kSeenFromInside:
    case Refusal::kUnmeasured:
      return kNotSeen;
    case Refusal::kScore:
      return kLowScore;
    case Refusal::kSupport:
      return kMetSupport;
    default:
      // The hand does not open so wide, or something else is asked for than a view can show.
      return 0.0;
  }
}

}  // namespace

bool may_fit(const SceneBody& body, const Gripper& gripper, const PlanOptions& options,
             const Eigen::Vector3d& up_C) {
  const double room = gripper.max_opening - 2.0 * options.pad_margin;
  const Eigen::Vector3d up_B = body.X_CB.linear().transpose() * up_C;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(up_B[k]) > kUpright) continue;
    if (body.size[k] - kSigmas * body.std[k] <= room) return true;
  }
  return false;
}

Prospect prospect_of(const SceneBody& body, const GraspPlan& plan, const Gripper& gripper,
                     const PlanOptions& options, const Eigen::Vector3d& up_C) {
  const double score = best_score(plan, body);
  if (score >= kSureScore) return {};
  if (score > 0.0) return {score >= kNearlySureScore ? kNearlySure : kUnsure, true};
  const bool fits = may_fit(body, gripper, options, up_C);
  return {chance_without_grasp(refusals_of(plan, body), fits), false};
}

double chance_by_view(const Prospect& prospect, double share, double angle, double height) {
  const double log_odds = kNoChange - (prospect.has_grasp ? kHarder : 0.0) +
                          kByShare * std::min(share / kEnoughShare, 1.0) +
                          kByAngle * std::min(angle / kEnoughAngle, 1.0) +
                          kByHeight * std::clamp(height / kEnoughHeight, 0.0, 1.0);
  return prospect.chance / (1.0 + std::exp(-log_odds));
}

}  // namespace quadrille
