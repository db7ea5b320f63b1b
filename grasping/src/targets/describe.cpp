#include "targets/describe.hpp"

#include <algorithm>

#include "contacts/quality.hpp"
#include "hand/hand.hpp"

namespace quadrille {
namespace {

// More clearance, or more room beside each pad, than this is no further advantage to a grasp [m].
constexpr double kFullClearance = 0.01, kFullRoom = 0.005;
// A soft pad touches on a disc whose radius is about this share of the pad's shorter side.
constexpr double kDiscToPad = 0.25;

/// Returns true if the surface was measured next to a contact.
bool observed(const Eigen::Vector3d& contact_C, const OccupancyGrid& space) {
  const double step = space.resolution();
  for (int n = 0; n < 27; ++n) {
    const Eigen::Vector3i steps(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const Eigen::Vector3d offset = steps.cast<double>();
    if (space.at(contact_C + step * offset) == Voxel::kOccupied) return true;
  }
  return false;
}

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

}  // namespace

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
  grasp.clearance = task.scene.clearance(
      sweep_hand(task.parts.gripper, grasp.X_CG, grasp.preshape, grasp.width, grasp.approach));
  const int seen = observed(line.contacts_C[0], *task.parts.space) +
                   observed(line.contacts_C[1], *task.parts.space);
  grasp.unknown_contact = seen < 2;
  ScoreTerms terms;
  terms.friction = (1.0 - grasp.friction_needed / task.parts.options.friction) * attempt.straight;
  terms.clearance = grasp.clearance / kFullClearance;
  terms.observed = 0.5 * seen;
  terms.room = 0.5 * (grasp.preshape - line.opening) / kFullRoom;
  terms.central = 1.0 - (line.centre_C - target.body.centre_C()).norm() / reach;
  // Full distrust of a detection, or a score that is NaN, halves the score of its grasps.
  const double confidence = target.confidence > 0.0 ? std::min(target.confidence, 1.0) : 0.0;
  grasp.score = grasp_score(terms) * (0.5 + 0.5 * confidence);
  return grasp;
}

}  // namespace quadrille
