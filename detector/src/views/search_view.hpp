#pragma once

#include <optional>

#include "base/stage_clock.hpp"
#include "quadrille/detector/options.hpp"
#include "surfaces/find_surfaces.hpp"
#include "views/scene.hpp"

namespace quadrille {

/// Finds the planes and the other surfaces of one view near the origin; nullopt if the cloud is too
/// small.
/// @param find   empty for find_candidates()
/// @param clock  receives the stages
std::optional<Scene> search_view(const CloudView& cloud, const DetectorOptions& options,
                                 const FindCandidates& find, StageClock& clock);

}  // namespace quadrille
