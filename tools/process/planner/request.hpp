#pragma once

#include <lcmtypes/quadrille/grasp_request_t.hpp>
#include <string>

#include "poses/placement.hpp"
#include "quadrille/grasping/grasp_query.hpp"

namespace quadrille {

/// Returns the query of a request, in frame K of the camera.
/// @param placement  placement of the cloud that the request is about
/// @param cloud_frame  name of the cloud's frame C
/// @throws std::invalid_argument naming the field that is wrong, and the remedy
GraspQuery query_of(const grasp_request_t& request, const Placement& placement,
                    const std::string& cloud_frame);

}  // namespace quadrille
