#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <vector>

#include "base/deadline.hpp"
#include "body/body.hpp"
#include "body/shell.hpp"
#include "contacts/contact_line.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/refusal.hpp"
#include "space/collision.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// True if a detection is to be grasped, and is not only in the way. A box is if its faces are.
bool is_wanted(const Detection& detection, const PlanOptions& options);

/// One detection or box that could be grasped, and all that its planning needs.
struct Target {
  int id = 0;
  /// Type and track of the detection; a box is a plane without track.
  QuadricType type = QuadricType::kPlane;
  int track = 0;
  double confidence = 1.0;
  Body body;
  /// Standard deviation of its points about its surface [m].
  double noise = 0.0;
  /// The planes that it stands on, the nearest first.
  std::vector<SupportPlane> supports;
  /// Its wall, if it is open at one end, and the lines across it where it was measured.
  std::optional<Shell> shell;
  std::vector<ContactLine> rim;
  /// Lines across it where it was not measured.
  int unmeasured = 0;
  /// False if it can be held by its wall alone.
  bool solid = true;
  /// False if nobody asked for it. It is kept because it says, as all others do, which space
  /// matters and what things stand on.
  bool wanted = true;
  /// The box that it is.
  std::optional<Box> box;

  /// Unit normal of what it stands on; zero if that is not known.
  Eigen::Vector3d up_C() const;
};

/// The detections that the hand may hold, across or by their rims, and what was refused of those
/// that are wanted.
struct ChosenTargets {
  std::vector<Target> targets;
  /// Why the others are none, by id.
  std::map<int, Refusal> refused;
  RefusalCounts refusals;

  void refuse(int id, Refusal why) {
    ++refusals[why];
    refused.emplace(id, why);
  }
};
ChosenTargets choose_targets(const PointCloud& cloud, const std::vector<Detection>& detections,
                             const DepthView& view, const Gripper& gripper,
                             const PlanOptions& options, const Deadline& deadline);

/// The boxes that the hand may hold across two parallel faces, and what was refused.
ChosenTargets choose_boxes(const PointCloud& cloud, const std::vector<Box>& boxes,
                           const std::vector<Detection>& detections, const Gripper& gripper,
                           const PlanOptions& options, const Deadline& deadline);

/// How far the hand reaches from a target's surface, its approach included [m].
double hand_reach(const Gripper& gripper, double approach);

/// The body's bounds in frame C, grown by a distance [m].
Eigen::AlignedBox3d around(const Body& body, double distance);

}  // namespace quadrille
