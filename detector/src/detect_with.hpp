#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/stage_clock.hpp"
#include "quadrille/detector/detector.hpp"
#include "surfaces/find_surfaces.hpp"
#include "views/scene.hpp"

namespace quadrille {

/// detect() with another way to search a level.
DetectionResult detect_with(const FindCandidates& find, const CloudView& cloud,
                            const DetectorOptions& options);

/// detect(), with someone who is told when each stage ends.
DetectionResult detect_watched(StageWatch watch, const CloudView& cloud,
                               const DetectorOptions& options);

/// Makes one scene of the scenes of each view; nullopt if there is nothing to make it of.
/// @param scenes   those of the usable views; none if there are no such views
/// @param shift_C  what was added to all points of the clouds, so that they are near the origin [m]
using JoinScenes =
    std::function<std::optional<Scene>(std::vector<Scene> scenes, const Eigen::Vector3d& shift_C)>;

/// detect_views() with another way to join the views.
DetectionResult detect_joined(const JoinScenes& join, std::span<const CloudView> views,
                              const DetectorOptions& options);

}  // namespace quadrille
