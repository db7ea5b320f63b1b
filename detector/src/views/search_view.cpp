#include "views/search_view.hpp"

#include <memory>
#include <utility>

#include "planes/plane_claims.hpp"
#include "samples/sample_tree.hpp"

namespace quadrille {

std::optional<Scene> search_view(const CloudView& cloud, const DetectorOptions& options,
                                 const FindCandidates& find, StageClock& clock) {
  const std::shared_ptr<const CellPyramid> cells = make_pyramid(cloud, options.sampling);
  clock.end("cells");
  if (!cells) return std::nullopt;
  Scene scene;
  const CellPyramid& pyramid = *cells;
  scene.views.push_back({cloud, cells, {}, {}});

  scene.coarse = pyramid.coarse_samples();
  scene.planes = find_planes(scene.coarse, options.planes);
  scene.plane_of_cell = planes_of_cells(pyramid, scene.coarse, scene.planes, options.planes.sigmas);
  clock.end("planes");

  SampleTree tree(pyramid, pyramid.samples(cells_off_planes(scene.plane_of_cell), options.threads));
  clock.end("samples");

  scene.context = {normal_of_largest(scene.planes), {pyramid.sight()}};
  scene.surfaces = find_surfaces(tree, scene.context, options, clock, {}, find).surfaces();
  scene.finest = std::move(tree).take_finest();
  return scene;
}

}  // namespace quadrille
