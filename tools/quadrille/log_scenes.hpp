#pragma once

#include <functional>

#include "cli/frame_arguments.hpp"
#include "quadrille/remembered_frames.hpp"
#include "view/log/log_backend.hpp"
#include "view/plan_choice.hpp"
#include "view/scene/scene_of_cloud.hpp"

namespace quadrille {

/// Returns how to plan, with what was chosen on the page.
/// @throws std::invalid_argument if the choice names something that does not exist
using ChooseSetup = std::function<view::PlanSetup(const view::PlanChoice&)>;

/// Makes scenes of the clouds of a log that each stand alone.
/// @param frames  the frame of the clouds, and where their camera stood
view::MakeScene scenes_alone(const FrameArguments& frames, const ChooseSetup& choose);

/// Makes scenes of the clouds of a log with what those before them showed.
view::MakeScene scenes_in_memory(RememberedFrames frames, const ChooseSetup& choose);

}  // namespace quadrille
