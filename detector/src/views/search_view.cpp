#include "views/search_view.hpp"

#include <memory>
#include <utility>

#include "planes/plane_claims.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "samples/sample_tree.hpp"

namespace quadrille {

namespace {

/// Finds the planes of a view, and makes samples of what lies beside them.
SampleTree samples_off_planes(const CellPyramid& pyramid, const DetectorOptions& options,
                              Scene* scene, StageClock& clock) {
  scene->coarse = pyramid.coarse_samples();
  scene->planes = find_planes(scene->coarse, options.planes);
  scene->plane_of_cell = planes_of_cells(pyramid, scene->coarse, scene->planes,
                                         options.planes.sigmas, options.threads);
  clock.end("planes");
  SampleTree tree(pyramid,
                  pyramid.samples(cells_off_planes(scene->plane_of_cell), options.threads));
  clock.end("samples");
  return tree;
}

}  // namespace

std::optional<Scene> search_view(const CloudView& cloud, const DetectorOptions& options,
                                 const FindCandidates& find, StageClock& clock) {
  const std::shared_ptr<const CellPyramid> cells = make_pyramid(cloud, options.sampling);
  clock.end("cells");
  if (!cells) return std::nullopt;
  Scene scene;
  ViewCells& view = scene.views.emplace_back();
  view.cloud = cloud;
  view.pyramid = cells;
  view.directions = std::make_shared<DirectionsOnDemand>(cloud, cells->view());

  // Boxes and lids nearly always need the directions, and with several threads they are found while
  // one thread is searching for planes, with one more at work for that moment than asked for. Later
  // two threads may ask for them at once.
  std::optional<SampleTree> tree;
  parallel_for(options.threads > 1 ? 2 : 1, options.threads, [&](int task) {
    if (task == 0) tree = samples_off_planes(*cells, options, &scene, clock);
    if (task == 1) view.directions->index();
  });

  scene.context = {normal_of_largest(scene.planes), {cells->sight()}};
  scene.surfaces = find_surfaces(*tree, scene.context, options, clock, {}, find).surfaces();
  scene.finest = std::move(*tree).take_finest();
  return scene;
}

}  // namespace quadrille
