#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Does what contradict_viewpoint() does for a cloud whose points are known to be in range.
std::string contradict_viewpoint_in_range(const CloudView& cloud,
                                          const std::vector<Detection>& detections);

}  // namespace quadrille
