#pragma once

#include <string>

#include "cli/paint.hpp"
#include "io/json.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// The detections of one cloud for people, a line each.
std::string detection_table(const io::InputInfo& input, const DetectionResult& result,
                            const Paint& paint);

/// The grasps of one cloud for people, a line each, with what was refused and why; if there are
/// none, also with what to try.
std::string grasp_table(const GraspPlan& plan, UnknownPolicy unknown, const Paint& paint);

}  // namespace quadrille
