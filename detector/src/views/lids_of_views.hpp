#pragma once

#include <span>
#include <vector>

#include "boxes/directions_on_demand.hpp"
#include "surfaces/lid_outline.hpp"
#include "views/scene.hpp"

namespace quadrille {

/// The points of each view of a scene by their directions. A view without points has none.
std::vector<DirectionsOnDemand> directions_of(const Scene& scene);

/// The outline of the lids of a round or elliptic cylinder in all views that have points; empty for
/// other surfaces.
/// @param directions  see directions_of()
std::vector<OutlinePoint> outline_of_lids(const Surface& surface, const Scene& scene,
                                          std::span<DirectionsOnDemand> directions);

}  // namespace quadrille
