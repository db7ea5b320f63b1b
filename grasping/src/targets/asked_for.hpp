#pragma once

#include <map>
#include <string>
#include <vector>

#include "quadrille/grasping/grasp_query.hpp"
#include "targets/target.hpp"

namespace quadrille {

/// Returns the targets that a query asks for, in their original order.
std::vector<const Target*> asked_for(const GraspQuery& query, const std::vector<Target>& targets);

/// Returns a sentence for each id that the query names but that is not a target.
/// @param why_none  what the other detections and boxes are, by id
std::vector<std::string> missed_ids(const GraspQuery& query, const std::vector<Target>& targets,
                                    const std::map<int, std::string>& why_none);

/// Explains in a sentence why a query matches none of the targets; empty if the ids explain it
/// already.
std::string why_none(const GraspQuery& query, const std::vector<Target>& targets);

}  // namespace quadrille
