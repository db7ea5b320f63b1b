#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.hpp"
#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/solid_shape.hpp"
#include "quadrille/grasping/plan.hpp"
#include "view/scene/voxel_layers.hpp"

namespace quadrille::view {

/// Number of refused candidates by the name of the reason.
using Rejected = std::map<std::string, std::int64_t>;

/// Properties of a body that the page shows with each of its parts; see SceneBody.
struct Sighting {
  /// Id of the body.
  int body = 0;
  /// Number of views that show it.
  int views = 1;
  /// Time since the newest of them [s].
  double unseen = 0.0;
  /// Track of the body; 0 if it has none.
  int track = 0;
  std::optional<BodyWall> wall = {};
};

/// Everything that is shown of one cloud, in one frame C.
struct Scene {
  /// Name of the input or of the channel.
  std::string name;
  std::int64_t utime = 0;
  std::int32_t seq = 0;
  PointCloud cloud;
  std::vector<Detection> detections;
  std::vector<Box> boxes;
  /// The bodies of unknown shape.
  std::vector<SceneBody> lumps;
  /// By the id of each body and of each of its parts.
  std::map<int, Sighting> sightings;
  /// The grasps, best first.
  std::vector<Grasp> grasps;
  /// Outcome of the trial of each grasp; empty if none was tried.
  std::vector<std::string> outcomes;
  std::string gripper_name;
  /// The gripper; without it the hand cannot be drawn.
  std::optional<Gripper> gripper;
  UnknownPolicy unknown = UnknownPolicy::kWeighed;
  /// Refusals of all targets, and by target if known.
  Rejected rejected;
  std::map<int, Rejected> rejected_of;
  /// Changes of a setting that give grasps to targets without one; empty if none were sought.
  std::vector<Remedy> remedies;
  /// Places from which the camera would see what the plan lacks.
  std::vector<Look> looks;
  VoxelLayers voxels;
  /// The robot's own shapes, and obstacles that no cloud need show.
  std::vector<SolidShape> robot, obstacles;
  /// Pose of the camera when it took the cloud, if poses tell it.
  std::optional<Eigen::Isometry3d> X_CK;
  /// The camera's last positions, oldest first [m].
  std::vector<Eigen::Vector3f> path;
  std::vector<StageTime> timings;
  /// What is shown of earlier clouds than this one.
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// Returns those of the bodies that are lumps.
std::vector<SceneBody> lumps_of(const std::vector<SceneBody>& bodies);

/// Returns how well the bodies and their parts are shown, by id.
std::map<int, Sighting> sightings_of(const std::vector<SceneBody>& bodies);

/// Limits of how much of a scene is shown.
struct PackLimits {
  std::size_t points = 80000, voxels = 20000, objects = 255, grasps = 1000;
};

/// Returns the grasps of a scene, the refusals, and the hand, in the form that the page expects.
io::Json plan_json(const Scene& scene, const PackLimits& limits = {});

/// Packs a scene in the form that the page expects: "QVW1", the length of the JSON as 32 bits, the
/// JSON, and the arrays, which the JSON names by their offset from its end. Little-endian.
std::string pack_scene(const Scene& scene, const PackLimits& limits = {});

}  // namespace quadrille::view
