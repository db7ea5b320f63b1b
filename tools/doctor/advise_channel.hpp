#pragma once

#include <string>

namespace quadrille::doctor {

/// Returns the options that make both processes listen to a channel on which messages came.
/// @param detector_option, planner_option  options that name the channel, such as "--in-channel"
/// @param prefix  value of --channel-prefix; empty for none
std::string advise_channel(const std::string& detector_option, const std::string& planner_option,
                           const std::string& channel, const std::string& prefix);

}  // namespace quadrille::doctor
