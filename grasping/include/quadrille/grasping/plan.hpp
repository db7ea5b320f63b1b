#pragma once

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille {

/// What unobserved space counts as while the hand moves through it.
enum class UnknownPolicy {
  kObstacle,      ///< all unknown space collides
  kTargetShadow,  ///< unknown space behind the target itself is free, the rest collides
  kFree,          ///< unknown space never collides
};

/// One two-finger grasp. Frame G: origin midway between the pads, z approach, y closing.
struct Grasp {
  /// Id of the detection to be grasped.
  int target = 0;
  /// 0 to 1, best first.
  double score = 0.0;
  Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
  /// Distance between the contacts [m], and opening of the hand on its way in [m].
  double width = 0.0, preshape = 0.0;
  /// Contact points in frame C [m].
  std::array<Eigen::Vector3d, 2> contacts_C;
  /// Length of the straight approach that was checked [m].
  double approach = 0.0;
  /// Least friction coefficient μ* that closes the grasp; of a hold by the tips, with the contacts
  /// where they are least good within what is known of them, PadMeeting::friction.
  double friction_needed = 0.0;
  /// Grasp quality ε: the largest wrench, of any direction, that a unit contact force resists.
  double epsilon = 0.0;
  /// Distance by which the hand may be inflated before it touches anything but the target [m].
  double clearance = 0.0;
  /// True if a contact lies on a part of the target that was not observed.
  bool unknown_contact = false;
};

struct PlanOptions {
  UnknownPolicy unknown = UnknownPolicy::kObstacle;
  /// Voxel edge of the occupancy map, and the size of the smallest things that it is to show where
  /// the sensor measured nothing [m].
  double resolution = 0.005;
  /// Friction coefficient between pads and objects.
  double friction = 0.5;
  /// Length of the straight approach to check [m].
  double approach = 0.05;
  /// Least distance of each pad from the target on the way in [m]; grows with the uncertainty of
  /// the target's size, by 4 mm at most.
  double pad_margin = 0.0025;
  /// Distance between a depth sensor's two eyes, or eye and projector [m]: the largest whose blind
  /// bands beside the edges of things count as seen through, up to the second eye's line of sight
  /// over the edge. 0: missing pixels tell nothing.
  double baseline = 0.09;
  /// Whether space beside the image and at missing pixels counts as free where it lies over space
  /// that was seen to be: what stands there would be seen below. Not if things may hang down.
  bool clear_above = true;
  /// Bounds of the thickness of walls held at their rim, which one view does not show [m].
  double wall_least = 0.002, wall_most = 0.008;
  /// Grasps to return at most.
  int max_grasps = 50;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

/// What the planner made of one cloud and its quadrics.
struct GraspPlan {
  /// Best first.
  std::vector<Grasp> grasps;
  /// Refused, counted by reason. Detections: "no_shape" (they bound no solid),
  /// "seen_from_inside" (a hollow whose rim was not seen). Contact lines: "unmeasured" (no points
  /// at the rim), "width" (wider than the hand opens), "friction" (would slip), "twist" (a wall
  /// that the pads would turn), "contradicted" (free space was seen where the surface should be).
  /// Approach directions: "unreachable" (from behind or below). Hands: "support" (would enter the
  /// plane the target stands on), "target" (the target itself), "collision" (occupied space or
  /// another detection), "unknown" (unobserved space).
  std::map<std::string, int> rejected;
  /// Of all detections that have any, those of one detection in a row.
  std::vector<CollisionShape> shapes;
  /// Free, occupied and unknown space around the targets; to_octree() makes an OctoMap of it.
  std::shared_ptr<const OccupancyGrid> space;
  std::vector<StageTime> timings;
  double total_ms = 0.0;
  std::vector<std::string> warnings;
};

/// Plans two-finger grasps on the detections of one cloud.
///
/// Contacts follow in closed form from each quadric; the hand, swept along its approach and while
/// it closes, is checked against the voxels, the planes and the shapes of all other detections, and
/// its opened fingers and palm against the target's own body. Deterministic.
/// @param further  more views of the same scene at rest, in the same frame C, each with its own
///                 viewpoint: what they show free or occupied is so
/// @throws std::invalid_argument if gripper or options are out of range
GraspPlan plan_grasps(const PointCloud& cloud, const std::vector<Detection>& detections,
                      const Gripper& gripper, const PlanOptions& options = {},
                      const std::vector<PointCloud>& further = {});

}  // namespace quadrille
