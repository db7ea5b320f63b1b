#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "contacts/candidates.hpp"
#include "contacts/contact_line.hpp"
#include "contacts/hold.hpp"
#include "targets/target_grasps.hpp"

namespace quadrille {

/// Returns the directions from which a hand may approach a target.
ApproachSpace approach_space(const TargetTask& task);

/// Returns how far the hand has to open for a line, including the margin that each pad keeps [m].
double min_opening(const ContactLine& line, const PlanOptions& options);

/// Returns the greatest distance between the contacts of a line across which the hand can open [m].
/// @param std  standard deviation of half that distance [m]
double max_width(double std, const TargetTask& task);

/// Returns kWidth if the hand cannot open that far, or cannot close that far.
std::optional<Refusal> misfit(const ContactLine& line, const TargetTask& task);

/// Returns true if free space was seen where the surface should be at a contact.
bool contradicted(const ContactLine& line, const OccupancyGrid& space);

/// One way to hold a target, before any collision check.
struct Attempt {
  ContactLine line;
  Eigen::Isometry3d X_CG;
  GraspKind kind = GraspKind::kAcross;
  /// Friction coefficient that the hold needs [-].
  double friction = 0.0;
  /// 1 if the pads lie straight on a wall; less if they lie askew, where the wall's bend twists it.
  double straight = 1.0;
  /// Set if the contacts follow from points rather than from a shape.
  std::optional<ContactEvidence> evidence = {};
  /// True if the target may be wider than the line within the reach of the pads, which walls are
  /// not.
  bool may_bulge = true;
  /// True if the place of a contact is a guess.
  bool guessed = false;
};

/// Tries hands on one target, one after the other, and keeps those that nothing obstructs.
class HandTrials {
 public:
  /// @param max_checks  number of collision checks after which the search ends
  /// @param usual_grasps  number of grasps with which the search ends, unless the query asks for
  ///                      more of each target
  HandTrials(const TargetTask& task, int max_checks, std::size_t usual_grasps);

  /// Returns true once there are enough grasps, enough was tried, or the deadline has passed.
  bool done();
  void refuse(Refusal why, int count = 1) { found_.refusals[why] += count; }
  /// Counts candidates that would score too little even with nothing in their way.
  void leave_out_unlikely(int count = 1) { found_.unlikely += count; }
  /// Returns true if a similar grasp was already accepted, so that this one would add nothing.
  bool resembles_accepted(const ContactLine& line, const Eigen::Vector3d& approach_C) const;
  /// Returns true, and counts a refusal, if the arm cannot bring the hand to any of these places.
  /// @param places_G  displacements of the hand from X_CG, in the axes of G [m]
  bool out_of_reach(const Eigen::Isometry3d& X_CG, const Eigen::AlignedBox3d& places_G);
  /// Returns true, and counts a refusal, if the palm collides wherever within `places_G` the hand
  /// is displaced from a line.
  bool palm_blocked(const ContactLine& line, const Eigen::Vector3d& approach_C,
                    const Eigen::AlignedBox3d& places_G);
  /// Returns true if an attempt is likely enough to be tried, and nothing is in the way of its
  /// fingers where they close, nor, if `and_palm`, of its palm. Nothing is counted.
  bool may_succeed(const Attempt& attempt, bool and_palm) const;
  /// Returns true if a grasp like this was accepted, so that no similar one need be tried.
  bool try_hand(const Attempt& attempt);
  TargetGrasps take() && { return std::move(found_); }

 private:
  bool is_unlikely(const Attempt& attempt) const;
  std::optional<Obstruction> closing_obstruction(const Attempt& attempt) const;
  std::optional<Obstruction> back_obstruction(const Attempt& attempt) const;
  void obstructed(Refusal why);
  /// Opens the hand less and less until a grasp is accepted. Returns why none is, which is what
  /// refused the last opening that was tried; nullopt if one is.
  std::optional<Refusal> try_openings(const Attempt& attempt);
  /// Accepts the grasp with this opening, or returns why not.
  std::optional<Refusal> try_opening(const Attempt& attempt, double preshape);
  std::optional<Refusal> unwanted(Grasp& grasp) const;

  const TargetTask& task_;
  int max_checks_;
  std::size_t max_grasps_;
  int checks_ = 0;
  TargetGrasps found_;
};

}  // namespace quadrille
