#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/grasping/candidates.hpp"
#include "quadrille/grasping/collision.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/rim.hpp"
#include "quadrille/grasping/tip_holds.hpp"

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

/// Plans the grasps of one target: those that survive, diverse, in no order.
class TargetPlanner {
 public:
  TargetPlanner(const Target& target, const Gripper& gripper, const PlanOptions& options,
                const OccupancyGrid& grid, const CollisionScene& scene)
      : target_(target), gripper_(gripper), options_(options), grid_(grid), scene_(scene) {}

  /// Grasps across the whole body.
  std::vector<Grasp> plan(const Eigen::Vector3d& viewpoint_C, std::map<std::string, int>& rejected);
  /// Grasps across the wall of its shell, at the rim.
  std::vector<Grasp> plan_rim(const Eigen::Vector3d& viewpoint_C,
                              std::map<std::string, int>& rejected);

 private:
  ApproachSpace approach_space(const Eigen::Vector3d& viewpoint_C) const;
  bool fits(const ContactLine& line, std::map<std::string, int>& rejected) const;
  bool usable(const ContactLine& line, std::map<std::string, int>& rejected) const;
  ContactLine narrowed(ContactLine line) const;
  bool contradicted(const ContactLine& line) const;
  bool observed(const Eigen::Vector3d& contact_C) const;
  bool resembles_accepted(const ContactLine& line, const Eigen::Vector3d& approach_C) const;
  std::vector<double> preshapes(const ContactLine& line) const;
  void try_rim(const ContactLine& line, const GraspCandidate& candidate,
               std::map<std::string, int>& rejected);
  void try_candidate(const ContactLine& line, const GraspCandidate& candidate,
                     std::map<std::string, int>& rejected);
  bool try_depth(const ContactLine& line, const Eigen::Vector3d& approach_C, double depth,
                 std::map<std::string, int>& rejected);
  bool try_chords(const ContactLine& line, const Eigen::Vector3d& approach_C,
                  std::map<std::string, int>& rejected);
  void try_tips(const ApproachSpace& space, std::map<std::string, int>& rejected);
  double passed_by_tips(const ContactLine& line, double off,
                        const Eigen::Vector3d& approach_C) const;
  Grasp describe(const ContactLine& line, const Eigen::Isometry3d& X_CG, double preshape) const;
  double straight(const Grasp& grasp, const ContactLine& line) const;
  void rate(Grasp& grasp, const ContactLine& line) const;
  double margin(const ContactLine& line) const;
  double least_opening(const ContactLine& line) const;

  const Target& target_;
  const Gripper& gripper_;
  const PlanOptions& options_;
  const OccupancyGrid& grid_;
  const CollisionScene& scene_;
  // Across a wall, whose thickness is not known, and no longer than the pads.
  bool at_rim_ = false;
  // The hold that is being tried: its contacts are where pads meet the body, edges included.
  const TipHold* by_tips_ = nullptr;
  int checks_ = 0;
  std::vector<Grasp> accepted_;
};

}  // namespace quadrille
