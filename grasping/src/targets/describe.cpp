#include "targets/describe.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contacts/quality.hpp"
#include "contacts/success.hpp"
#include "hand/hand.hpp"
#include "targets/target_name.hpp"
#include "targets/terms.hpp"

namespace quadrille {
namespace {

// More clearance than this is no further advantage to a grasp [m].
constexpr double kFullClearance = 0.01;
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

/// Returns true if the surface was measured next to a contact.
/// @param resolution  of the space [m]
bool was_seen(const Eigen::Vector3d& contact_C, const ObstacleMap& space, double resolution) {
  for (int n = 0; n < 27; ++n) {
    const Eigen::Vector3i steps(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const Eigen::Vector3d offset = steps.cast<double>();
    if (space.is_occupied(contact_C + resolution * offset)) return true;
  }
  return false;
}

}  // namespace

Grasp describe(const Attempt& attempt, double preshape, const TargetTask& task) {
  const ContactLine& line = attempt.line;
  const Target& target = task.target;
  const double reach = 0.5 * target.body.bounds_Q().sizes().maxCoeff();
  Grasp grasp;
  const TargetName name = name_of(target, task.query);
  grasp.target = name.id;
  grasp.track = name.track;
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
  grasp.terms = terms_of(attempt, preshape, task);
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
