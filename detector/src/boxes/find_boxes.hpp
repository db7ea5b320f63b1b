#pragma once

#include <vector>

#include "boxes/face.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Makes boxes from the planes among the detections of a cloud near the origin, and from flat
/// patches of the cloud that are too small to be detected as planes; see the public
/// find_boxes().
/// @param view  what find_view() returns for the cloud; null if that is not known
std::vector<Box> find_boxes(const CloudView& cloud, const PinholeView* view,
                            const std::vector<Detection>& detections,
                            const std::vector<FlatPatch>& patches);

}  // namespace quadrille
