#pragma once

#include <vector>

#include "boxes/box_hints.hpp"
#include "boxes/directions_on_demand.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Makes boxes from the planes among the detections of a cloud near the origin, and from hints
/// where there may be boxes whose faces were not detected as planes; see the public find_boxes().
/// @param threads  number of threads, each at another face; it never changes the result
std::vector<Box> find_boxes(DirectionsOnDemand& directions,
                            const std::vector<Detection>& detections, const BoxHints& hints,
                            int threads = 1);

}  // namespace quadrille
