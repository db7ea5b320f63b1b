#include "views/view_search.hpp"

#include <utility>

#include "planes/plane_claims.hpp"

namespace quadrille {

std::optional<ViewSearch> search_view(const CloudView& cloud, const DetectorOptions& options,
                                      const FindCandidates& find, StageClock& clock) {
  ViewSearch view;
  view.cloud = cloud;
  view.pyramid = make_pyramid(cloud, options.sampling);
  clock.end("cells");
  if (!view.pyramid) return std::nullopt;

  view.coarse = view.pyramid->coarse_samples();
  view.planes = find_planes(view.coarse, options.planes);
  view.plane_of_cell =
      planes_of_cells(*view.pyramid, view.coarse, view.planes, options.planes.sigmas);
  clock.end("planes");

  SampleTree tree(*view.pyramid,
                  view.pyramid->samples(cells_off_planes(view.plane_of_cell), options.threads));
  clock.end("samples");

  view.context = {normal_of_largest(view.planes), {view.pyramid->sight()}};
  view.surfaces = find_surfaces(tree, view.context, options, clock, {}, find).surfaces();
  view.finest = std::move(tree).take_finest();
  return view;
}

}  // namespace quadrille
