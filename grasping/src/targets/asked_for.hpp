#pragma once

#include <string>
#include <vector>

#include "quadrille/grasping/grasp_query.hpp"
#include "targets/target.hpp"

namespace quadrille {

/// The targets that a query asks for, in their order.
std::vector<const Target*> asked_for(const GraspQuery& query, const std::vector<Target>& targets);

/// Why a query asks for none of the targets, in a sentence.
/// @param refused  why other detections and boxes are no targets, by id
std::string why_none(const GraspQuery& query, const std::vector<Target>& targets,
                     const std::map<int, Refusal>& refused);

}  // namespace quadrille
