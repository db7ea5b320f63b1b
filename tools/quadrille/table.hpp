#pragma once

#include <string>
#include <vector>

#include "cli/paint.hpp"
#include "io/json/json.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Returns a readable table of the detections of one cloud, one per line.
std::string detection_table(const io::InputInfo& input, const DetectionResult& result,
                            const Paint& paint);

/// Returns a readable table of the grasps of one cloud, one per line, with what was refused and
/// why. Lines follow on each target without a grasp: why it has none, and what would give it one.
/// @param advised  whether remedies were sought
std::string grasp_table(const GraspPlan& plan, bool advised, const Paint& paint);

/// Lists the views that would help, a line each; empty if there are none.
std::string look_table(const std::vector<Look>& looks);

}  // namespace quadrille
