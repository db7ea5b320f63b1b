#pragma once

#include <functional>
#include <vector>

#include "lab/experiments/experiment.hpp"
#include "lab/scene/scene.hpp"

namespace quadrille::experiments {

/// A surface with fewer visible pixels than this counts as hidden.
inline constexpr int kMinPixels = 300;

/// Makes the scenes of each family from the seed and calls `work` for each, family by family;
/// reports the progress.
void for_each_scene(const std::vector<scene::Family>& families, int scenes,
                    const Settings& settings, const std::function<void(const scene::Scene&)>& work);

}  // namespace quadrille::experiments
