#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Returns true if planes are all that was found, so that there is nothing to grasp.
bool has_only_planes(const DetectionResult& result);

/// Detects again with smaller cells, which show smaller things, and plans on what is found then.
/// @param views  the clouds of the scene, for detect_views()
/// @param plan   plans on detections
/// @return the remedy, without a target; empty if it gives no grasp, or cells are as small already
std::vector<Remedy> try_finer_cells(std::span<const PointCloud> views, DetectorOptions options,
                                    const std::function<GraspPlan(DetectionResult)>& plan);

/// Says what is known of smaller cells if only planes were found.
/// @param advised  whether they were tried
std::string hint_at_finer_cells(const std::vector<Remedy>& remedies, bool advised);

}  // namespace quadrille
