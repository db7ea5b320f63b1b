#pragma once

#include "io/json.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille::io {

/// One grasp.
Json to_json(const Grasp& grasp);

/// One collision shape.
Json to_json(const CollisionShape& shape);

/// What was asked for: the conditions alone that were given, in the frame of the results.
Json to_json(const GraspQuery& query);

/// What `quadrille plan --json` writes for one cloud; total_ms spans detection and planning.
Json plan_json(const InputInfo& input, const RunInfo& run, const DetectionResult& result,
               const GraspPlan& plan);

}  // namespace quadrille::io
