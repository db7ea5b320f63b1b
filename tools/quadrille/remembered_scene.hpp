#pragma once

#include "quadrille/remembered_frames.hpp"
#include "view/scene/scene.hpp"
#include "view/scene/scene_of_cloud.hpp"

namespace quadrille {

/// Plans on a cloud of a log with what is remembered of those before it, and shows both in the
/// fixed frame W: the bodies that earlier clouds showed, the space that all of them saw, and the
/// camera and its path. A cloud whose pose is not known is shown alone, in its own frame.
/// @param setup  how to plan; its robot is replaced by what the log says
view::Scene remembered_scene(const RememberedFrame& frame, view::PlanSetup setup);

}  // namespace quadrille
