#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "base/cloud_runs.hpp"
#include "base/deadline.hpp"
#include "body/body.hpp"
#include "body/shell.hpp"
#include "contacts/contact_line.hpp"
#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/refusal.hpp"
#include "space/collision.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// Returns true if a detection is to be grasped rather than being only an obstacle. A box is wanted
/// if one of its faces is.
bool is_wanted(const Detection& detection, const PlanOptions& options);

/// A detection or box that could be grasped, with all that planning its grasps needs.
struct Target {
  int id = 0;
  /// Type of the detection; a box is a plane.
  QuadricType type = QuadricType::kPlane;
  /// Track of the detection, or of the body if the target is no detection; 0 if it has none.
  int track = 0;
  /// Id of the body that the target is or is a part of; its own if there is none.
  int body_id = 0;
  /// Track of that body, and of what has the id of the body, which may be its main part; 0 if it
  /// has none.
  int body_track = 0, main_track = 0;
  double confidence = 1.0;
  Body body;
  /// Standard deviation of the points about the surface [m].
  double noise = 0.0;
  /// The planes that the target stands on, the nearest first.
  std::vector<SupportPlane> supports;
  /// Index of the view that shows most of the target.
  std::size_t view = 0;
  /// The wall, if the target is open at one end, and the lines across it at which it was measured.
  std::optional<Shell> shell;
  std::vector<ContactLine> rim;
  /// Number of lines across the wall at which it was not measured.
  int unmeasured = 0;
  /// False if the target can be held only by its wall, or if its shape is not known: then its body
  /// is merely the box around its points.
  bool solid = true;
  /// True for a lump, whose box holds all of its points: others that are connected with them belong
  /// to what touches it.
  bool whole = false;
  /// False if the target is not asked for. It is kept because, like all others, it tells which
  /// space matters and what things stand on.
  bool wanted = true;
  /// The box, if the target is one.
  std::optional<Box> box;

  /// Unit normal of the support; zero if it is not known.
  Eigen::Vector3d up_C() const;
};

/// The detections that the hand may hold, across or by their rims, and the refusals among those
/// that are wanted.
struct ChosenTargets {
  std::vector<Target> targets;
  /// Why other detections are not targets, by id.
  std::map<int, Refusal> refused;
  /// Number of lines across rims that were not measured.
  int unmeasured = 0;
};
ChosenTargets choose_targets(const CloudRuns& cloud, const std::vector<Detection>& detections,
                             std::span<const DepthView> views, const Gripper& gripper,
                             const PlanOptions& options, const Deadline& deadline);

/// Chooses the boxes that the hand may hold across two parallel faces, and counts the refusals.
ChosenTargets choose_boxes(const CloudRuns& cloud, const std::vector<Box>& boxes,
                           const std::vector<Detection>& detections, const Gripper& gripper,
                           const PlanOptions& options, const Deadline& deadline);

/// Returns a target for each body of unknown shape, such as a lump, and for each whose shape is
/// none of the targets.
/// @param targets  those with a shape
std::vector<Target> choose_unshaped(const std::vector<SceneBody>& bodies,
                                    const std::vector<Target>& targets,
                                    const std::vector<Detection>& detections,
                                    const PlanOptions& options);

/// Tells targets of which bodies they are parts.
void add_bodies(const std::vector<SceneBody>& bodies, const std::vector<Detection>& detections,
                std::vector<Target>* targets);

/// Returns how far the hand reaches from a target's surface, including its approach [m].
double hand_reach(const Gripper& gripper, double approach);

/// Returns the body's bounds in frame C, grown by a distance [m].
Eigen::AlignedBox3d around(const Body& body, double distance);

}  // namespace quadrille
