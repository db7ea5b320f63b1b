#pragma once

#include <cstddef>
#include <string>

#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille {

/// The quadrics of one message for people: a line about its cloud, then a line each.
std::string published_table(const std::string& channel, const bus::QuadricsMessage& message);

/// The boxes of one message for people: a line about its cloud, then a line each.
std::string published_table(const std::string& channel, const bus::BoxesMessage& message);

/// The best grasps of one message for people: a line about its cloud, then a line each; if there
/// are none, what was refused and why.
std::string published_table(const std::string& channel, const grasps_t& message,
                            std::size_t max_grasps);

}  // namespace quadrille
