#pragma once

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Detects the quadrics of one cloud by the method of Birdal et al., CVPR 2018.
///
/// The same cloud, options and seed give the same bits, whatever the thread count.
/// @throws std::invalid_argument if an option is out of range (the message names the field)
DetectionResult detect(const PointCloud& cloud, const DetectorOptions& options = {});

}  // namespace quadrille
