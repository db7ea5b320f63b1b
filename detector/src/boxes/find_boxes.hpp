#pragma once

#include <vector>

#include "boxes/directions_on_demand.hpp"
#include "boxes/face.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Makes boxes from the planes among the detections of a cloud near the origin, and from flat
/// patches of the cloud that are too small to be detected as planes; see the public
/// find_boxes().
/// @param threads  number of threads, each at another face; it never changes the result
std::vector<Box> find_boxes(DirectionsOnDemand& directions,
                            const std::vector<Detection>& detections,
                            const std::vector<FlatPatch>& patches, int threads = 1);

}  // namespace quadrille
