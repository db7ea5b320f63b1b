#pragma once

#include <vector>

#include "io/json/json.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille::io {

/// Returns one grasp.
Json to_json(const Grasp& grasp);

/// Returns one collision shape.
Json to_json(const CollisionShape& shape);

/// Returns what is known besides the clouds; empty if nothing is.
Json to_json(const Surroundings& known);

/// Returns what became of a target.
Json to_json(const TargetOutcome& outcome);

/// Returns the list of remedies.
Json to_json(const std::vector<Remedy>& remedies);

/// Returns the list of proposed views.
Json to_json(const std::vector<Look>& looks);

/// Returns the query: only the conditions that were given, in the frame of the results.
Json to_json(const GraspQuery& query);

/// Returns what `quadrille plan --json` writes for one cloud; total_ms includes detection and
/// planning.
Json plan_json(const InputInfo& input, const RunInfo& run, const DetectionResult& result,
               const GraspPlan& plan);

}  // namespace quadrille::io
