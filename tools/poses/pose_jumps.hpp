#pragma once

#include "poses/pose_history.hpp"

namespace quadrille {

/// True if the poses about a cloud are not to be trusted, since they jumped: no camera moves from
/// one of them to the other in the time between, or some of the last second jumped and did not come
/// back. Then one is wrong, or the fixed frame was set anew, as it is believed after a second.
///
/// If many poses of the history jump, the camera is put from place to place, and all are trusted.
/// @param bracket  the poses before and after the cloud; no pose after it if one has its very time
bool have_jumped(const PoseHistory& history, const PoseBracket& bracket);

}  // namespace quadrille
