#pragma once

#include "base/deadline.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/plan.hpp"
#include "targets/scene_parts.hpp"

namespace quadrille {

/// Returns the grasps that a query, completed() by the scene's options, asks for, as far as they
/// are found before the deadline.
GraspPlan answer_query(const SceneParts& parts, const GraspQuery& query, const Deadline& deadline);

}  // namespace quadrille
