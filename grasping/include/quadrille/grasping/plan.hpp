#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/refusal.hpp"
#include "quadrille/grasping/surroundings.hpp"

namespace quadrille {

/// How the search for grasps of one target ended: of a body with all its parts, or of one part that
/// the query names. Detections and boxes that were refused as targets, and are no part of one, have
/// an outcome too.
struct TargetOutcome {
  /// Id of the detection, box or body.
  int target = 0;
  /// Number of grasps that were found; a plan holds no more than its largest number of all.
  int grasps = 0;
  /// The refused candidates; for a detection that is no target, the one reason.
  RefusalCounts refusals;
};

/// A change of one setting with which a target has a grasp.
struct Remedy {
  /// Id of the detection, box or body.
  int target = 0;
  /// The change, as on the command line: "--gripper robotiq_2f85".
  std::string change;
  /// Number of grasps of the target after the change, and the score of the best one.
  int grasps = 0;
  double score = 0.0;
};

/// A place from which the camera would see what the plan lacks.
struct Look {
  /// Pose of the camera's frame K in C: the origin is the viewpoint, z points ahead and x to the
  /// right.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity();
  /// Ids of the bodies that it would help, first those without a grasp, and of both kinds those
  /// with the largest chance first.
  std::vector<int> bodies;
  /// Number of these bodies that are expected to get a better grasp by it: the sum of the chances.
  double gain = 0.0;
};

/// The result of planning grasps on one cloud and its quadrics.
struct GraspPlan {
  /// The grasps, best first.
  std::vector<Grasp> grasps;
  /// Number of refused candidates by the name of the Refusal; reasons that did not occur are left
  /// out.
  std::map<std::string, int> rejected;
  /// The outcome for each target that was asked for.
  std::vector<TargetOutcome> targets;
  /// Changes that would give grasps to targets without one. A plan leaves them empty; callers of
  /// find_remedies() may keep its answer here.
  std::vector<Remedy> remedies;
  /// Views that would help bodies without a sure grasp. A plan leaves them empty; callers of
  /// propose_looks() may keep its answer here.
  std::vector<Look> looks;
  /// The boxes of which detected planes are faces; each box may be a target.
  std::vector<Box> boxes;
  /// The collision shapes of all boxes, and of all detections that have a shape and are not faces
  /// of boxes. Shapes of the same detection are adjacent.
  std::vector<CollisionShape> shapes;
  /// True if the deadline ended the search early, so that there may be further grasps.
  bool cut = false;
  /// Free, occupied and unknown space around the targets; to_octree() makes an OctoMap of it. Null
  /// if the deadline passed before space was mapped.
  std::shared_ptr<const OccupancyGrid> space;
  std::vector<StageTime> timings;
  double total_ms = 0.0;
  std::vector<std::string> warnings;
};

/// Plans two-finger grasps on the detections of one cloud.
///
/// Contacts follow in closed form from each quadric; for boxes (see find_boxes()) they lie across
/// parallel faces. Targets that cannot be held this way, and bodies without a known shape, are held
/// between their outermost points. The hand is swept along its approach and while it closes, and
/// checked against the voxels, the planes and the shapes of all other detections; its opened
/// fingers and palm are also checked against the target's own body. The result is deterministic
/// unless a deadline ends the search early: then it holds the grasps found in time, and a warning.
/// @param known  what else is known of the scene: more views, whose free and occupied space is
///               merged, the robot, a support, a map
/// @param query  which grasps are wanted; to ask more than once, use GraspScene
/// @param boxes  the boxes that were found in the cloud together with the detections, see
///               DetectionResult::boxes; if not given, they are sought among the detected planes
/// @param bodies  the bodies that were found with the detections, see DetectionResult::bodies; a
///                body without a known shape, such as a lump, is a target under its own id
/// @throws std::invalid_argument if gripper, options, surroundings or query are out of range
QUADRILLE_EXPORT GraspPlan plan_grasps(const PointCloud& cloud,
                                       const std::vector<Detection>& detections,
                                       const Gripper& gripper, const PlanOptions& options = {},
                                       const Surroundings& known = {}, const GraspQuery& query = {},
                                       std::optional<std::vector<Box>> boxes = {},
                                       const std::vector<SceneBody>& bodies = {});

}  // namespace quadrille
