#pragma once

#include <string>

#include "doctor/finding.hpp"
#include "doctor/pose_recorder.hpp"

namespace quadrille::doctor {

/// Checks that valid poses of the camera come, keep coming, have the clock of the clouds, and come
/// often and soon enough for processes with the default settings to place every cloud.
/// @param prefix  value of --channel-prefix, with which the channel begins
/// @return what is wrong, or one finding that all is well
Findings check_poses(const PoseArrivals& heard, const std::string& prefix = "");

}  // namespace quadrille::doctor
