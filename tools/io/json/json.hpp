#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// JSON whose keys stay in the order in which they are documented.
using Json = nlohmann::ordered_json;

struct RunInfo;

/// Facts about a cloud that are known before anything is computed.
struct InputInfo {
  /// Path, with a message number for logs.
  std::string input;
  std::string frame;
  /// Number of points that the source announced.
  std::size_t points_read = 0;
  /// Time from opening the file to the decoded cloud [ms].
  double read_ms = 0.0;
  /// Position of the sensor, in that frame [m].
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
};

/// Returns {"position": [3] [m], "quaternion": [w, x, y, z]}, with w >= 0.
Json to_json(const Eigen::Isometry3d& X);

/// Returns one detection, with "track" if it has one. Numbers keep all their digits; numbers that
/// are not finite become null.
Json to_json(const Detection& detection);

/// Returns one box: its faces as ids of detections, and in its own frame the part that was seen
/// ("inner") and the greatest possible extent ("outer").
Json to_json(const Box& box);

/// Returns {"thickness", "std"} [m].
Json to_json(const BodyWall& wall);
/// Returns bodies, in their order; an infinite deviation becomes null.
Json to_json(const SceneBody& body);
Json to_json(const std::vector<SceneBody>& bodies);

/// Returns boxes, in their order.
Json to_json(const std::vector<Box>& boxes);

/// Returns detections, in their order.
Json to_json(const std::vector<Detection>& detections);

/// Returns what `quadrille detect --json` writes for one cloud.
Json detect_json(const InputInfo& input, const RunInfo& run, const DetectionResult& result);

}  // namespace quadrille::io
