#pragma once

#include <vector>

#include "lab/scoring/frame.hpp"

namespace quadrille::bench {

/// Returns the points of each true body with a curved surface as a cloud of its own: a perfect
/// segmentation, for fits that take one object. Table, walls, boxes and what belongs to no surface
/// are left out.
std::vector<PointCloud> given_objects(const scoring::Frame& frame);

}  // namespace quadrille::bench
