#pragma once

#include <functional>
#include <optional>
#include <string>

#include "io/json/json.hpp"
#include "view/live/latest_messages.hpp"
#include "view/scene/scene.hpp"

namespace quadrille::view {

/// Returns the gripper with this name; nullopt if it is not known.
using FindGripper = std::function<std::optional<Gripper>(const std::string& name)>;

/// Combines what belongs to one cloud: the newest quadrics with their cloud and boxes. Grasps and
/// occupancy come later. Until then those of an earlier cloud are shown, with grasps assigned to
/// the surfaces of the same track. A cloud in another frame than the quadrics is moved into theirs,
/// if the camera's poses tell how.
/// @param cloud_in_world  true if clouds are in the fixed frame of the camera's poses; else they
///   are in the camera's frame
/// @param unit  length of the unit of the clouds' coordinates [m]
Scene live_scene(const LatestMessages& messages, const FindGripper& find_gripper,
                 const PackLimits& limits = {}, bool cloud_in_world = false, double unit = 1.0);

/// Makes a scene of the grasps with which the planner answers a question; nullopt if the bytes are
/// damaged.
std::optional<Scene> scene_of_answer(const Bytes& grasps, const FindGripper& find_gripper,
                                     const PackLimits& limits = {});

/// Returns rate, latency and losses of both processes in readable form; messages that cannot be
/// decoded are left out.
io::Json live_status(const LatestMessages& messages);

}  // namespace quadrille::view
