#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille::io {

/// Keys stay in the order in which they are documented.
using Json = nlohmann::ordered_json;

/// What is known of a cloud before anything is computed.
struct InputInfo {
  /// Path, with a message number for logs.
  std::string input;
  std::string frame;
  /// Points that the source announced.
  std::size_t points_read = 0;
  /// From the opened file to the decoded cloud [ms].
  double read_ms = 0.0;
};

/// {"position": [3] [m], "quaternion": [w, x, y, z]}, with w >= 0.
Json to_json(const Eigen::Isometry3d& X);

/// One detection, with "track" if it has one. Numbers keep all their digits; one that is not finite
/// becomes null.
Json to_json(const Detection& detection);

/// One grasp.
Json to_json(const Grasp& grasp);

/// One collision shape.
Json to_json(const CollisionShape& shape);

/// What `quadrille detect --json` writes for one cloud.
Json detect_json(const InputInfo& input, const DetectionResult& result);

/// What `quadrille plan --json` writes for one cloud; total_ms spans detection and planning.
Json plan_json(const InputInfo& input, const DetectionResult& result, const GraspPlan& plan);

}  // namespace quadrille::io
