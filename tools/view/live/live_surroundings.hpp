#pragma once

#include "view/live/latest_messages.hpp"
#include "view/live/scene_frames.hpp"
#include "view/scene/scene.hpp"

namespace quadrille::view {

/// What to do if poses are missing, for warnings.
inline constexpr const char* kPoseRemedy = "give view the --pose-channel of the processes";

/// Adds what messages say of the robot and of obstacles, and the camera's path, in the frame of the
/// scene. What cannot be brought into it is left out; a warning says so.
void add_surroundings(const LatestMessages& messages, const SceneFrames& frames, Scene* scene);

}  // namespace quadrille::view
