#pragma once

#include <cstdint>
#include <string>

#include "doctor/finding.hpp"
#include "doctor/traffic.hpp"

namespace quadrille::doctor {

/// Checks that clouds come, and on the channel on which the detector expects them.
/// @param cloud_channel  channel, or pattern of channels
/// @param prefix  value of --channel-prefix, with which the channel begins
Finding check_clouds(const Traffic& traffic, const std::string& cloud_channel, double seconds,
                     const std::string& prefix = "");

/// Checks that no messages get lost on their way to this machine.
/// @param port  port of the LCM address
Finding check_losses(const Traffic& traffic, int port);

/// Checks that only one process does each work on each channel, and that each channel carries one
/// type of message.
/// @param cloud_channel  channel, or pattern of channels
Findings check_others(const Traffic& traffic, const std::string& cloud_channel);

/// Checks that messages carry distinct times that agree with one clock.
/// @param now  this machine's clock [us since 1970]
Findings check_clocks(const Traffic& traffic, std::int64_t now);

}  // namespace quadrille::doctor
