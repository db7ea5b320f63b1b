#include "views/seen_view.hpp"

#include <cstddef>
#include <memory>
#include <utility>

#include "cloud/cloud_check.hpp"
#include "samples/sample_tree.hpp"

namespace quadrille {

SeenView seen_view(const CellPyramid& cells, const DetectorOptions& options) {
  const Mask all(static_cast<std::size_t>(cells.size(0)), 1);
  SampleTree tree(cells, cells.samples(all, options.threads));
  return SeenView{cells.sight(), std::move(tree).take_finest()};
}

std::optional<SeenView> seen_view(const CloudView& given, const DetectorOptions& options) {
  const CloudCheck check = check_cloud(given);
  if (!check.usable || !given.viewpoint.allFinite()) return std::nullopt;
  const std::unique_ptr<CellPyramid> cells =
      make_pyramid(check.range.kept(given), options.sampling);
  if (!cells) return std::nullopt;
  return seen_view(*cells, options);
}

}  // namespace quadrille
