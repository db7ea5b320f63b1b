#pragma once

#include <vector>

#include "quadrille/detector/body.hpp"
#include "views/scene.hpp"

namespace quadrille {

/// Notes for each body how many views show it, and how old the newest of them is.
/// @param owner  for each finest sample the id of the detection on which it lies; 0 or negative for
///   none that was asked for
/// @param plane_ids  for each plane of the scene the id of its detection; 0 for none
void note_views(const Scene& scene, const std::vector<int>& owner,
                const std::vector<int>& plane_ids, std::vector<SceneBody>* bodies);

}  // namespace quadrille
