#include "lab/trials/search_samples.hpp"

#include "planes/plane_claims.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille::trials {

std::optional<SearchSamples> search_samples(const PointCloud& cloud,
                                            const DetectorOptions& options) {
  const std::unique_ptr<CellPyramid> pyramid = make_pyramid(cloud, options.sampling);
  if (!pyramid) return std::nullopt;
  SearchSamples found{pyramid->coarse_samples(), {}, {}, nullptr};
  found.planes = find_planes(found.coarse, options.planes);
  found.context = {normal_of_largest(found.planes), {pyramid->sight()}};
  const Mask keep = cells_off_planes(
      planes_of_cells(*pyramid, found.coarse, found.planes, options.planes.sigmas));
  found.tree = std::make_unique<SampleTree>(*pyramid, pyramid->samples(keep, options.threads));
  return found;
}

}  // namespace quadrille::trials
