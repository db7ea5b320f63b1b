#pragma once

#include <functional>
#include <vector>

#include "lab/experiments/experiment.hpp"
#include "lab/scene/scene.hpp"

namespace quadrille::experiments {

/// A surface of which fewer pixels are seen is all but hidden.
inline constexpr int kMinPixels = 300;

/// Makes scenes of each family, which follow from the seed, and has each worked on, family by
/// family; tells the progress.
void for_each_scene(const std::vector<scene::Family>& families, int scenes,
                    const Settings& settings, const std::function<void(const scene::Scene&)>& work);

}  // namespace quadrille::experiments
