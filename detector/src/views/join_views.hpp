#pragma once

#include <vector>

#include "quadrille/detector/options.hpp"
#include "views/scene.hpp"

namespace quadrille {

/// Joins several views of one scene, at least one. The surfaces of each view are the candidates
/// for those of the scene: each is refitted to what it explains in all views, judged by the
/// evidence of all views, and joined with others that the same quadric explains.
/// @param views  scenes of one view each
Scene join_views(std::vector<Scene> views, const DetectorOptions& options);

}  // namespace quadrille
