#pragma once

#include <vector>

#include "bodies/find_bodies.hpp"
#include "bodies/support.hpp"

namespace quadrille {

/// Gives the unexplained points that are connected to a larger body to it, and makes lumps of the
/// others, divided at creases.
/// @param last_id  the largest id so far, which those of the lumps continue
/// @param bodies   the bodies so far, to which the lumps are added
void add_lumps(const BodySources& found, const std::vector<Support>& supports, int last_id,
               std::vector<SceneBody>* bodies);

}  // namespace quadrille
