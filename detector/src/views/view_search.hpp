#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/stage_clock.hpp"
#include "planes/planes.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/sample_tree.hpp"
#include "surfaces/evidence/scene_context.hpp"
#include "surfaces/find_surfaces.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// One view of a scene after its search. The cloud's points must outlive it.
struct ViewSearch {
  CloudView cloud;
  std::unique_ptr<CellPyramid> pyramid;
  /// The samples on which the planes were found, and for each finest cell its plane, −1 for none.
  SurfaceSamples coarse;
  std::vector<PlaneRegion> planes;
  std::vector<int> plane_of_cell;
  /// The samples beside the planes, and the surfaces that were found among them.
  SurfaceSamples finest;
  std::vector<Surface> surfaces;
  SceneContext context;
};

/// Finds the planes and the other surfaces of a view near the origin; nullopt if the cloud is too
/// small.
/// @param find   empty for find_candidates()
/// @param clock  receives the stages
std::optional<ViewSearch> search_view(const CloudView& cloud, const DetectorOptions& options,
                                      const FindCandidates& find, StageClock& clock);

}  // namespace quadrille
