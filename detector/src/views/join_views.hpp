#pragma once

#include <vector>

#include "quadrille/detector/options.hpp"
#include "samples/sight.hpp"
#include "views/scene.hpp"
#include "views/view_parts.hpp"

namespace quadrille {

/// What is known of one of several views of a scene, in frame C.
struct SceneView {
  ViewCells cells;
  ViewParts parts;
  Sight sight;
};

/// Joins several views of one scene, at least one. The surfaces of each view are the candidates
/// for those of the scene: each is refitted to what it explains in all views, judged by the
/// evidence of all views, and joined with others that the same quadric explains.
Scene join_views(std::vector<SceneView> views, const DetectorOptions& options);

/// The same with scenes of one view each. If there is a single one, it stays as it is.
Scene join_scenes(std::vector<Scene> views, const DetectorOptions& options);

/// The one view of a scene.
SceneView single_view(Scene scene);

}  // namespace quadrille
