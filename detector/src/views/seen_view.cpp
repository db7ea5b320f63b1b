#include "views/seen_view.hpp"

#include <cstddef>
#include <memory>
#include <utility>

#include "cloud/cloud_check.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/sample_tree.hpp"

namespace quadrille {

std::optional<SeenView> seen_view(const CloudView& given, const DetectorOptions& options) {
  const CloudCheck check = check_cloud(given);
  if (!check.usable || !given.viewpoint.allFinite()) return std::nullopt;
  const CloudView cloud = check.range.kept(given);
  const std::unique_ptr<CellPyramid> pyramid = make_pyramid(cloud, options.sampling);
  if (!pyramid) return std::nullopt;
  const Mask all(static_cast<std::size_t>(pyramid->size(0)), 1);
  SampleTree tree(*pyramid, pyramid->samples(all, options.threads));
  return SeenView{pyramid->sight(), std::move(tree).take_finest()};
}

}  // namespace quadrille
