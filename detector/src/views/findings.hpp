#pragma once

#include <cstddef>
#include <vector>

#include "base/stage_clock.hpp"
#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/options.hpp"
#include "views/scene.hpp"

namespace quadrille {

/// The detections, boxes and bodies that were found in a scene.
struct Findings {
  std::vector<Detection> detections;
  std::vector<Box> boxes;
  std::vector<SceneBody> bodies;
  std::size_t points_used = 0;
};

/// Measures the surfaces of a scene, numbers them, and makes boxes and bodies of them.
/// @param clock  receives the stages
Findings measure_scene(const Scene& scene, const DetectorOptions& options, StageClock& clock);

}  // namespace quadrille
