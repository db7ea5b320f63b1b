#pragma once

#include <cstddef>
#include <string>

#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille {

/// Returns a readable table of the quadrics of one message: a line about its cloud, then one per
/// quadric.
std::string published_table(const std::string& channel, const bus::QuadricsMessage& message);

/// Returns a readable table of the boxes of one message: a line about its cloud, then one per box.
std::string published_table(const std::string& channel, const bus::BoxesMessage& message);

/// Returns a readable table of the bodies of one message: a line about its cloud, then one per
/// body.
std::string published_table(const std::string& channel, const bus::BodiesMessage& message);

/// Returns a line about the cloud of one message, then one per body that has a track.
std::string published_table(const std::string& channel, const bus::BodyTracksMessage& message);

/// Returns a readable table of the best grasps of one message: a line about its cloud, then one per
/// grasp; if there are none, what was refused and why.
std::string published_table(const std::string& channel, const grasps_t& message,
                            std::size_t max_grasps);

/// Returns a line about what a process has done since it started, then one per warning.
std::string published_table(const std::string& channel, const detector_status_t& status);
std::string published_table(const std::string& channel, const planner_status_t& status);

}  // namespace quadrille
