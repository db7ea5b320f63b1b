#include "targets/describe.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contacts/pad_cover.hpp"
#include "contacts/quality.hpp"
#include "contacts/success.hpp"
#include "hand/hand.hpp"

namespace quadrille {
namespace {

// More clearance, or more room beside each pad, than this is no further advantage to a grasp [m].
constexpr double kFullClearance = 0.01, kFullRoom = 0.005;
// Points beside a contact that reach farther along the approach than this are no further advantage,
// and distances from the sensor beyond this no further disadvantage [m].
constexpr double kFullHeight = 0.02, kFullRange = 1.5;
// With this share of the friction to spare, errors of normals no longer decide: of 0.5 it is 8°.
constexpr double kFullReserve = 0.3;
// A shape whose half width is so uncertain tells nothing about the contacts [m].
constexpr double kUnsure = 0.005;
// A soft pad touches on a disc whose radius is about this share of the pad's shorter side.
constexpr double kDiscToPad = 0.25;

/// Computes the quality ε with torques scaled by half the target's largest size; γ = 2/3 μ r for a
/// disc of radius r.
double epsilon(const ContactLine& line, const TargetTask& task, double reach) {
  ContactModel model;
  model.friction = task.parts.options.friction;
  model.torsion =
      2.0 / 3.0 * task.parts.options.friction * kDiscToPad * task.parts.gripper.pad.minCoeff();
  model.torque_scale = reach;
  return grasp_epsilon(line, model);
}

/// Returns the share of the boxes that was seen.
double seen_share(const std::array<OrientedBox, 2>& boxes, const OccupancyGrid& space) {
  // A box is looked at in the middles of so many parts; along x, a finger's breadth, it is
  // thinnest.
  constexpr int kAlongX = 3, kAlongY = 5, kAlongZ = 5;
  int seen = 0;
  for (const OrientedBox& box : boxes) {
    for (int n = 0; n < kAlongX * kAlongY * kAlongZ; ++n) {
      const int i = n % kAlongX, j = n / kAlongX % kAlongY, k = n / (kAlongX * kAlongY);
      const Eigen::Vector3d step((i + 0.5) / kAlongX, (j + 0.5) / kAlongY, (k + 0.5) / kAlongZ);
      const Eigen::Vector3d p_B = (2.0 * step.array() - 1.0) * box.half.array();
      seen += space.at(box.p_CB + box.R_CB * p_B) != Voxel::kUnknown;
    }
  }
  return static_cast<double>(seen) / (2 * kAlongX * kAlongY * kAlongZ);
}

/// Returns the share of the pads' length along which a wall reaches out nearly as far as at a
/// contact across which it leans. Tips hold at one place, and the hand lies along walls that it
/// holds at the rim.
double flat_share(const Grasp& grasp, const TargetTask& task) {
  if (grasp.kind != GraspKind::kAcross) return 1.0;
  const double behind = grasp.friction_needed * 2.0 * task.parts.gripper.finger_front;
  return behind > kNearlyAsFar ? kNearlyAsFar / behind : 1.0;
}

GraspTerms terms_of(const Attempt& attempt, const Grasp& grasp, const TargetTask& task) {
  const ContactLine& line = attempt.line;
  const Body& body = task.target.body;
  const double reach = 0.5 * body.bounds_Q().sizes().maxCoeff();
  const Eigen::Vector3d to_sensor = task.parts.view_of(task.target).p_CV() - body.centre_C();
  GraspTerms terms;
  const double spare = 1.0 - grasp.friction_needed / task.parts.options.friction;
  terms.friction = spare * attempt.straight;
  terms.reserve = std::clamp(spare / kFullReserve, 0.0, 1.0);
  terms.clearance = 1.0;
  terms.room = std::min(1.0, 0.5 * (grasp.preshape - line.opening) / kFullRoom);
  terms.central = std::max(0.0, 1.0 - (line.centre_C - body.centre_C()).norm() / reach);
  terms.seen = 1.0;
  terms.confidence = std::clamp(task.target.confidence, 0.0, 1.0);
  terms.range = std::min(1.0, to_sensor.norm() / kFullRange);
  terms.rim = grasp.kind == GraspKind::kRim ? 1.0 : 0.0;
  terms.shape = attempt.evidence ? 0.0 : 1.0;
  terms.inner = attempt.evidence ? attempt.evidence->inner : 1.0;
  terms.height = attempt.evidence ? std::min(1.0, attempt.evidence->height / kFullHeight) : 1.0;
  terms.facing = attempt.evidence ? attempt.evidence->facing : 1.0;
  terms.filled = attempt.evidence ? attempt.evidence->filled : 1.0;
  terms.flat = attempt.evidence ? attempt.evidence->flat : flat_share(grasp, task);
  terms.sure = 1.0 - std::min(1.0, line.std / kUnsure);
  return terms;
}

}  // namespace

bool was_seen(const Eigen::Vector3d& contact_C, const ObstacleMap& space, double resolution) {
  for (int n = 0; n < 27; ++n) {
    const Eigen::Vector3i steps(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const Eigen::Vector3d offset = steps.cast<double>();
    if (space.is_occupied(contact_C + resolution * offset)) return true;
  }
  return false;
}

Grasp describe(const Attempt& attempt, double preshape, const TargetTask& task) {
  const ContactLine& line = attempt.line;
  const Target& target = task.target;
  const double reach = 0.5 * target.body.bounds_Q().sizes().maxCoeff();
  Grasp grasp;
  grasp.target = target.id;
  grasp.track = target.track;
  grasp.kind = attempt.kind;
  grasp.X_CG = attempt.X_CG;
  grasp.width = line.width;
  grasp.preshape = preshape;
  grasp.contacts_C = line.contacts_C;
  grasp.approach = task.parts.options.approach;
  grasp.friction_needed = attempt.friction;
  grasp.epsilon = epsilon(line, task, reach);
  grasp.clearance = kMaxClearance;
  const double resolution = task.parts.space->resolution();
  grasp.unknown_contact = attempt.guessed ||
                          !was_seen(line.contacts_C[0], *task.parts.map, resolution) ||
                          !was_seen(line.contacts_C[1], *task.parts.map, resolution);
  grasp.terms = terms_of(attempt, grasp, task);
  grasp.score = success_probability(grasp.terms);
  return grasp;
}

void measure_seen(Grasp& grasp, const TargetTask& task) {
  if (task.parts.options.unknown == UnknownPolicy::kFree) return;
  const auto fingers = common_fingers(task.parts.gripper, grasp.X_CG, grasp.preshape, grasp.width);
  grasp.terms.seen = seen_share(fingers, *task.parts.space);
  grasp.score = success_probability(grasp.terms);
}

void measure_clearance(Grasp& grasp, const TargetTask& task) {
  grasp.clearance = task.scene.clearance(sweep_hand(task.parts.gripper, grasp.X_CG, grasp.preshape,
                                                    grasp.width, grasp.approach, task.attached_G));
  grasp.terms.clearance = std::min(1.0, grasp.clearance / kFullClearance);
  grasp.score = success_probability(grasp.terms);
}

}  // namespace quadrille
