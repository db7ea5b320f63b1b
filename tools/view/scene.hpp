#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "view/voxel_layers.hpp"

namespace quadrille::view {

/// How many candidates were refused, by the name of the reason.
using Rejected = std::map<std::string, std::int64_t>;

/// What is shown of one cloud; all in one frame C.
struct Scene {
  /// The input's name, or the channel's.
  std::string name;
  std::int64_t utime = 0;
  std::int32_t seq = 0;
  PointCloud cloud;
  std::vector<Detection> detections;
  std::vector<Box> boxes;
  /// Best first.
  std::vector<Grasp> grasps;
  /// What came of each when it was tried; empty: none was.
  std::vector<std::string> outcomes;
  std::string gripper_name;
  /// None: the hand cannot be drawn.
  std::optional<Gripper> gripper;
  UnknownPolicy unknown = UnknownPolicy::kObstacle;
  /// Of all targets, and by target where that is known.
  Rejected rejected;
  std::map<int, Rejected> rejected_of;
  VoxelLayers voxels;
  std::vector<StageTime> timings;
  std::vector<std::string> warnings;
};

/// How much of a scene is shown at most.
struct PackLimits {
  std::size_t points = 80000, voxels = 20000, objects = 255, grasps = 1000;
};

/// The grasps of a scene, why others were refused, and the hand, as the page takes them.
io::Json plan_json(const Scene& scene, const PackLimits& limits = {});

/// A scene as the page takes it: "QVW1", the length of the JSON as 32 bits, the JSON, and the
/// arrays that it names by their offset from its end. Little-endian.
std::string pack_scene(const Scene& scene, const PackLimits& limits = {});

}  // namespace quadrille::view
