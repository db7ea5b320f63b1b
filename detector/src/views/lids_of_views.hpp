#pragma once

#include <vector>

#include "surfaces/lid_outline.hpp"
#include "views/scene.hpp"

namespace quadrille {

/// The outline of the lids of a round or elliptic cylinder in all views that have points; empty for
/// other surfaces.
std::vector<OutlinePoint> outline_of_lids(const Surface& surface, const Scene& scene);

}  // namespace quadrille
