#pragma once

#include <cstdint>
#include <string>

#include "doctor/finding.hpp"
#include "doctor/traffic.hpp"

namespace quadrille::doctor {

/// Whether clouds come, and on the channel on which the detector looks for them.
/// @param cloud_channel  or a pattern of channels
/// @param prefix         of --channel-prefix, with which that begins
Finding check_clouds(const Traffic& traffic, const std::string& cloud_channel, double seconds,
                     const std::string& prefix = "");

/// Whether messages got lost on their way to this machine.
/// @param port  of the LCM address
Finding check_losses(const Traffic& traffic, int port);

/// Whether only one process does each work on each channel, and one type comes on each.
/// @param cloud_channel  or a pattern of channels
Findings check_others(const Traffic& traffic, const std::string& cloud_channel);

/// Whether messages tell times that can be told apart, of one clock.
/// @param now  this machine's clock [us since 1970]
Findings check_clocks(const Traffic& traffic, std::int64_t now);

}  // namespace quadrille::doctor
