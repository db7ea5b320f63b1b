#pragma once

#include <chrono>

#include "doctor/pose_recorder.hpp"
#include "doctor/traffic.hpp"
#include "link/url.hpp"

namespace quadrille::doctor {

/// Receives everything that is sent to the multicast group of a udpm address, without LCM and
/// without changing what others receive. This is needed because an LCM handler does not learn who
/// sent a message.
/// @param poses  records the times of poses and clouds
/// @throws std::runtime_error if no socket can be made or the group cannot be joined
Traffic listen(const bus::Url& url, std::chrono::milliseconds duration, PoseRecorder* poses);

}  // namespace quadrille::doctor
