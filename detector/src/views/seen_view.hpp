#pragma once

#include <memory>
#include <optional>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/sight.hpp"
#include "views/samples_on_demand.hpp"

namespace quadrille {

/// A view's depths, and the finest samples of all that it sees, in the cloud's frame.
struct SeenView {
  Sight sight;
  SamplesOnDemand samples;
};

/// @param cells  the cells of the view's cloud
SeenView seen_view(std::shared_ptr<const CellPyramid> cells, const DetectorOptions& options);

/// Returns nullopt if the cloud is too small, or its viewpoint is not known.
std::optional<SeenView> seen_view(const CloudView& cloud, const DetectorOptions& options);

}  // namespace quadrille
