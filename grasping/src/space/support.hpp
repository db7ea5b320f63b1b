#pragma once

#include <vector>

#include "body/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "space/collision.hpp"

namespace quadrille {

/// Returns the detected planes that the body stands on, the nearest to its centre first.
std::vector<SupportPlane> supports_of(const Body& body, const std::vector<Detection>& detections);

/// Returns a plane that is known without being detected. Its extent reaches farther than any hand.
/// @param near_C  a place near the origin of the plane's frame [m]
SupportPlane plane_of(const KnownSupport& support, const Eigen::Vector3d& near_C);

}  // namespace quadrille
