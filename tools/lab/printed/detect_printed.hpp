#pragma once

#include "lab/printed/settings.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::printed {

/// Detects quadrics by the paper's printed pipeline, or by a pipeline between it and the detector;
/// by default the same as detect(). Unless surfaces are refitted, a detection has only its type,
/// quadric, canonical form, score and inliers, which are samples. Ranked by inliers, the score of a
/// plane is its share of the coarsest samples, and that of a curved surface its share of the finest
/// ones off the planes; ranked by evidence, a curved surface has its confidence.
/// @param cloud  near the origin
/// @throws std::invalid_argument if an option is out of range
DetectionResult detect_printed(const PointCloud& cloud, const Settings& settings);

}  // namespace quadrille::printed
