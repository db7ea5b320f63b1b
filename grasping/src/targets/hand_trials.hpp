#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <utility>

#include "contacts/candidates.hpp"
#include "contacts/contact_line.hpp"
#include "targets/target_grasps.hpp"

namespace quadrille {

/// From which directions a hand may come to a target.
ApproachSpace approach_space(const TargetTask& task);

/// How far the hand has to open for a line, with the margin that each pad keeps from it [m].
double min_opening(const ContactLine& line, const PlanOptions& options);

/// kWidth if the hand does not open as far, or does not close as far.
std::optional<Refusal> misfit(const ContactLine& line, const TargetTask& task);

/// True if free space was seen where the surface should be at a contact.
bool contradicted(const ContactLine& line, const OccupancyGrid& space);

/// One way to hold a target, before any collision check.
struct Attempt {
  ContactLine line;
  Eigen::Isometry3d X_CG;
  GraspKind kind = GraspKind::kAcross;
  /// Friction coefficient that it needs [-].
  double friction = 0.0;
  /// 1 if the pads lie straight on a wall; less if they lie askew, where its bend twists it.
  double straight = 1.0;
  /// True if the target may be wider than the line within the reach of the pads. Walls are not.
  bool may_bulge = true;
};

/// Tries hands on one target, one after the other, and keeps those that nothing is in the way of.
class HandTrials {
 public:
  /// @param max_checks  of collisions, beyond which it is done
  /// @param max_grasps  with which it is done
  HandTrials(const TargetTask& task, int max_checks, std::size_t max_grasps)
      : task_(task), max_checks_(max_checks), max_grasps_(max_grasps) {}

  /// True once there are enough grasps, or enough was tried, or the deadline has passed.
  bool done();
  void refuse(Refusal why, int count = 1) { found_.refusals[why] += count; }
  /// True if there is a grasp much like this, so that it would add nothing.
  bool resembles_accepted(const ContactLine& line, const Eigen::Vector3d& approach_C) const;
  /// True, and counted, if the palm is in the way of something wherever within `places_G` the hand
  /// is moved from a line.
  bool palm_blocked(const ContactLine& line, const Eigen::Vector3d& approach_C,
                    const Eigen::AlignedBox3d& places_G);
  /// True if there is now a grasp like this, so that none like it need be tried.
  bool try_hand(const Attempt& attempt);
  /// What was found; the last call.
  TargetGrasps take() { return std::move(found_); }

 private:
  void obstructed(Refusal why);

  const TargetTask& task_;
  int max_checks_;
  std::size_t max_grasps_;
  int checks_ = 0;
  TargetGrasps found_;
};

}  // namespace quadrille
