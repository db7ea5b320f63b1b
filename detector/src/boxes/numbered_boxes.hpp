#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Boxes that were found before, in the frame C of newer detections: their ids continue those of
/// the detections, and their faces are the planes that lie on their sides.
std::vector<Box> numbered_boxes(std::vector<Box> boxes, const std::vector<Detection>& detections);

}  // namespace quadrille
