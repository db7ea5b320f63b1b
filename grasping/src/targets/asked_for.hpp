#pragma once

#include <map>
#include <string>
#include <vector>

#include "quadrille/grasping/grasp_query.hpp"
#include "targets/target.hpp"

namespace quadrille {

/// The targets that a query asks for, in their order.
std::vector<const Target*> asked_for(const GraspQuery& query, const std::vector<Target>& targets);

/// A sentence for each id that a query names and that is no target.
/// @param why_none  what other detections and boxes are, by id
std::vector<std::string> missed_ids(const GraspQuery& query, const std::vector<Target>& targets,
                                    const std::map<int, std::string>& why_none);

/// Why a query asks for none of the targets, in a sentence; empty if its ids say all.
std::string why_none(const GraspQuery& query, const std::vector<Target>& targets);

}  // namespace quadrille
