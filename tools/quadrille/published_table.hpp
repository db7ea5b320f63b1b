#pragma once

#include <cstddef>
#include <string>

#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille {

/// Returns a readable table of the quadrics of one message: a line about its cloud, then one per
/// quadric.
std::string published_table(const std::string& channel, const bus::QuadricsMessage& message);

/// Returns a readable table of the boxes of one message: a line about its cloud, then one per box.
std::string published_table(const std::string& channel, const bus::BoxesMessage& message);

/// Returns a readable table of the best grasps of one message: a line about its cloud, then one per
/// grasp; if there are none, what was refused and why.
std::string published_table(const std::string& channel, const grasps_t& message,
                            std::size_t max_grasps);

}  // namespace quadrille
