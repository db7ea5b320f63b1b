#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "body/body.hpp"
#include "contacts/candidates.hpp"
#include "contacts/contact_line.hpp"
#include "contacts/rim.hpp"
#include "contacts/tip_holds.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan.hpp"
#include "space/collision.hpp"

namespace quadrille {

/// One detection to be grasped, and all that its planning needs.
struct Target {
  int id = 0;
  double confidence = 1.0;
  Body body;
  /// The planes that it stands on, the nearest first.
  std::vector<SupportPlane> supports;
  /// Its wall, if it is open at one end, and the lines across it where it was measured.
  std::optional<Shell> shell;
  std::vector<ContactLine> rim;
  /// False if it can be held by its wall alone.
  bool solid = true;
};

/// One way to hold a target, before any collision check.
struct Attempt {
  ContactLine line;
  Eigen::Isometry3d X_CG;
  /// Friction coefficient that it needs [-].
  double friction = 0.0;
  /// 1 if the pads lie straight on a wall; less if they lie askew, where its bend twists it.
  double straight = 1.0;
  /// True if the target may be wider than the line within the reach of the pads. Walls are not.
  bool may_bulge = true;
};

/// Plans the grasps of one target: those that survive, diverse, in no order. Its effort is limited
/// in all: each object is for one of the plans, and for one call.
class TargetPlanner {
 public:
  TargetPlanner(const Target& target, const Gripper& gripper, const PlanOptions& options,
                const OccupancyGrid& grid, const CollisionScene& scene)
      : target_(target), gripper_(gripper), options_(options), grid_(grid), scene_(scene) {}

  /// Grasps across the whole body.
  std::vector<Grasp> plan(const Eigen::Vector3d& viewpoint_C, std::map<std::string, int>& rejected);
  /// Grasps by the tips, wherever these reach: a longer search, for where nothing else is to be
  /// had.
  std::vector<Grasp> plan_tips(const Eigen::Vector3d& viewpoint_C,
                               std::map<std::string, int>& rejected);
  /// Grasps across the wall of its shell, at the rim.
  std::vector<Grasp> plan_rim(const Eigen::Vector3d& viewpoint_C,
                              std::map<std::string, int>& rejected);

 private:
  using Counts = std::map<std::string, int>;
  // The farthest chord above the widest part, as a share of half the width: about as far as normal
  // friction holds a ball there.
  static constexpr double kMaxBeside = 0.36;

  // From one depth along the pads that is tried to the next [m].
  double depth_step() const { return 0.33 * gripper_.pad.y(); }
  ApproachSpace approach_space(const Eigen::Vector3d& viewpoint_C) const;
  bool fits(const ContactLine& line, Counts& rejected) const;
  bool usable(const ContactLine& line, Counts& rejected) const;
  ContactLine narrowed(ContactLine line) const;
  bool contradicted(const ContactLine& line) const;
  bool observed(const Eigen::Vector3d& contact_C) const;
  bool resembles_accepted(const ContactLine& line, const Eigen::Vector3d& approach_C) const;
  std::vector<double> preshapes(const ContactLine& line) const;
  void try_rim(const ContactLine& line, const Eigen::Vector3d& approach_C, Counts& rejected);
  void try_across(const ContactLine& line, const Eigen::Vector3d& approach_C, Counts& rejected);
  bool blocked(const ContactLine& line, const Eigen::Vector3d& approach_C, Counts& rejected);
  bool try_depth(const ContactLine& line, const Eigen::Vector3d& approach_C, double depth,
                 Counts& rejected);
  bool try_chords(const ContactLine& line, const Eigen::Vector3d& approach_C, Counts& rejected);
  double passed_by_tips(const ContactLine& line, double off,
                        const Eigen::Vector3d& approach_C) const;
  bool try_hand(const Attempt& attempt, Counts& rejected);
  void refuse(Obstruction what, Counts& rejected);
  Grasp describe(const Attempt& attempt, double preshape) const;
  void rate(Grasp& grasp, const Attempt& attempt) const;
  double margin(const ContactLine& line) const;
  double min_opening(const ContactLine& line) const;

  const Target& target_;
  const Gripper& gripper_;
  const PlanOptions& options_;
  const OccupancyGrid& grid_;
  const CollisionScene& scene_;
  int checks_ = 0;
  std::vector<Grasp> accepted_;
};

}  // namespace quadrille
