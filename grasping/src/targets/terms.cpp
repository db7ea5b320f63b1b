#include "targets/terms.hpp"

#include <algorithm>
#include <cmath>

#include "contacts/pad_cover.hpp"
#include "contacts/quality.hpp"
#include "contacts/score_calibration.hpp"
#include "contacts/success.hpp"

namespace quadrille {
namespace {

// More room beside each pad than this is no further advantage to a grasp [m].
constexpr double kFullRoom = 0.005;
// Points beside a contact that reach farther along the approach than this are no further advantage,
// and distances from the sensor beyond this no further disadvantage [m].
constexpr double kFullHeight = 0.02, kFullRange = 1.5;
// With this share of the friction to spare, errors of normals no longer decide: of 0.5 it is 8°.
constexpr double kFullReserve = 0.3;
// A shape whose half width is so uncertain tells nothing about the contacts [m].
constexpr double kUnsure = 0.005;

/// Returns the share of the pads' length along which a wall reaches out nearly as far as at a
/// contact across which it leans. Tips hold at one place, and the hand lies along walls that it
/// holds at the rim.
double flat_share(const Attempt& attempt, const TargetTask& task) {
  if (attempt.kind != GraspKind::kAcross) return 1.0;
  const double behind = attempt.friction * 2.0 * task.parts.gripper.finger_front;
  return behind > kNearlyAsFar ? kNearlyAsFar / behind : 1.0;
}

// Beyond this distance [m], where cameras see things coarsely, the best hold by points lost more
// than this against one with perfect contacts, in the log odds that the weights give: of 148
// targets in simulated and real scenes one lost 0.97, one 1.10, and all others 1.2 or more.
constexpr double kFarForPoints = 1.2, kLostFarAway = 1.15;

double log_odds(double probability) { return std::log(probability / (1.0 - probability)); }

double sure(double std) { return 1.0 - std::min(1.0, std / kUnsure); }

/// Returns the terms of the best grasp of its shape that the target could have.
GraspTerms best_terms(const Target& target, const SceneParts& parts) {
  const Eigen::Vector3d to_sensor = parts.view_of(target).p_CV() - target.body.centre_C();
  GraspTerms terms;
  GraspTerms::visit(terms, [](const char*, double& term) { term = 1.0; });
  terms.confidence = std::clamp(target.confidence, 0.0, 1.0);
  terms.range = std::min(1.0, to_sensor.norm() / kFullRange);
  terms.rim = 0.0;
  return terms;
}

}  // namespace

GraspTerms terms_of(const Attempt& attempt, double preshape, const TargetTask& task) {
  const ContactLine& line = attempt.line;
  const Body& body = task.target.body;
  const double reach = 0.5 * body.bounds_Q().sizes().maxCoeff();
  GraspTerms terms = best_terms(task.target, task.parts);
  const double spare =
      1.0 - doubted_friction(attempt.friction, line.lean_std) / task.parts.options.friction;
  terms.friction = spare * attempt.straight;
  terms.reserve = std::clamp(spare / kFullReserve, 0.0, 1.0);
  terms.room = std::min(1.0, 0.5 * (preshape - line.opening) / kFullRoom);
  terms.central = std::max(0.0, 1.0 - (line.centre_C - body.centre_C()).norm() / reach);
  terms.rim = attempt.kind == GraspKind::kRim ? 1.0 : 0.0;
  terms.sure = sure(line.std);
  if (!attempt.evidence) {
    terms.flat = flat_share(attempt, task);
    return terms;
  }
  terms.shape = 0.0;
  terms.inner = attempt.evidence->inner;
  terms.height = std::min(1.0, attempt.evidence->height / kFullHeight);
  terms.facing = attempt.evidence->facing;
  terms.filled = attempt.evidence->filled;
  terms.flat = attempt.evidence->flat;
  return terms;
}

double best_score(const Attempt& attempt, const TargetTask& task) {
  return success_probability(terms_of(attempt, task.parts.gripper.max_opening, task));
}

double best_shape_score(double std, const TargetTask& task) {
  GraspTerms terms = best_terms(task.target, task.parts);
  terms.sure = sure(std);
  return success_probability(terms);
}

bool near_enough_for_points(const Target& target, const SceneParts& parts, double min_score) {
  const double distance = (parts.view_of(target).p_CV() - target.body.centre_C()).norm();
  if (distance < kFarForPoints) return true;
  GraspTerms terms = best_terms(target, parts);
  terms.shape = 0.0;
  const double lost = kCalibrationSlope * kLostFarAway;
  return log_odds(success_probability(terms)) - lost >= log_odds(min_score);
}

}  // namespace quadrille
