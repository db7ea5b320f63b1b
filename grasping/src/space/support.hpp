#pragma once

#include <vector>

#include "body/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "space/collision.hpp"

namespace quadrille {

/// Returns the detected planes that the body stands on, the nearest to its centre first.
std::vector<SupportPlane> supports_of(const Body& body, const std::vector<Detection>& detections);

}  // namespace quadrille
