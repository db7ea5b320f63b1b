#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/body.hpp"
#include "quadrille/grasping/collision.hpp"

namespace quadrille {

/// The planes among the detections that the body stands on, the nearest to its middle first.
std::vector<SupportPlane> supports_of(const Body& body, const std::vector<Detection>& detections);

}  // namespace quadrille
