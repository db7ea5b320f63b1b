#pragma once

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// True if the options ask for spheres and nothing else, for which detect() takes the paper's
/// type-specific path.
bool seeks_spheres_alone(const DetectorOptions& options);

/// The options with which that path works: a sphere's hypothesis needs one point and no null space,
/// and its growth and its fit no choice among families.
DetectorOptions sphere_options(DetectorOptions options);

/// Detects the quadrics of one cloud by the method of Birdal et al., CVPR 2018.
///
/// The same cloud, options and seed give the same bits, whatever the thread count.
/// @throws std::invalid_argument if an option is out of range (the message names the field)
DetectionResult detect(const PointCloud& cloud, const DetectorOptions& options = {});

}  // namespace quadrille
