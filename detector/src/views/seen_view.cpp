#include "views/seen_view.hpp"

#include <utility>

#include "cloud/cloud_check.hpp"

namespace quadrille {

SeenView seen_view(std::shared_ptr<const CellPyramid> cells, const DetectorOptions& options) {
  Sight sight = cells->sight();
  return {std::move(sight), SamplesOnDemand(std::move(cells), options.threads)};
}

std::optional<SeenView> seen_view(const CloudView& given, const DetectorOptions& options) {
  const CloudCheck check = check_cloud(given);
  if (!check.usable || !given.viewpoint.allFinite()) return std::nullopt;
  std::shared_ptr<const CellPyramid> cells =
      make_pyramid(check.range.kept(given), options.sampling);
  if (!cells) return std::nullopt;
  return seen_view(std::move(cells), options);
}

}  // namespace quadrille
