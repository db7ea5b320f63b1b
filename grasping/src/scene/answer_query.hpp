#pragma once

#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/plan.hpp"
#include "scene/scene_parts.hpp"

namespace quadrille {

/// The grasps that a query asks for.
GraspPlan answer_query(const SceneParts& parts, const GraspQuery& query);

}  // namespace quadrille
