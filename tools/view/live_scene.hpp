#pragma once

#include <functional>
#include <optional>
#include <string>

#include "io/json.hpp"
#include "view/latest_messages.hpp"
#include "view/scene.hpp"

namespace quadrille::view {

/// The hand of that name; nullopt if it is not known.
using FindGripper = std::function<std::optional<Gripper>(const std::string& name)>;

/// Puts together what belongs to one cloud: the newest quadrics with their cloud and boxes. Grasps
/// and occupancy come later; those of an earlier cloud are shown until then, the grasps on the
/// surfaces that have the same track.
Scene live_scene(const LatestMessages& messages, const FindGripper& find_gripper,
                 const PackLimits& limits = {});

/// Grasps alone, as the planner answers a question; nullopt if the bytes are damaged.
std::optional<Scene> scene_of_answer(const Bytes& grasps, const FindGripper& find_gripper,
                                     const PackLimits& limits = {});

/// Rate, latency and losses of both processes, for people; what cannot be decoded is left out.
io::Json live_status(const LatestMessages& messages);

}  // namespace quadrille::view
