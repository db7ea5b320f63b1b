#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Keys stay in the order in which they are documented.
using Json = nlohmann::ordered_json;

struct RunInfo;

/// What is known of a cloud before anything is computed.
struct InputInfo {
  /// Path, with a message number for logs.
  std::string input;
  std::string frame;
  /// Points that the source announced.
  std::size_t points_read = 0;
  /// From the opened file to the decoded cloud [ms].
  double read_ms = 0.0;
  /// Where the sensor stood, in that frame [m].
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
};

/// {"position": [3] [m], "quaternion": [w, x, y, z]}, with w >= 0.
Json to_json(const Eigen::Isometry3d& X);

/// One detection, with "track" if it has one. Numbers keep all their digits; one that is not finite
/// becomes null.
Json to_json(const Detection& detection);

/// One box: its faces as ids of detections, and in its own frame what was seen of it ("inner") and
/// what it may reach at most ("outer").
Json to_json(const Box& box);

/// Boxes, in their order.
Json to_json(const std::vector<Box>& boxes);

/// Detections, in their order.
Json to_json(const std::vector<Detection>& detections);

/// What `quadrille detect --json` writes for one cloud.
Json detect_json(const InputInfo& input, const RunInfo& run, const DetectionResult& result);

}  // namespace quadrille::io
