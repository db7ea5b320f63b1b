#pragma once

#include "lab/printed/settings.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::printed {

/// Detects quadrics by the paper's printed pipeline, or by a pipeline between it and the detector;
/// by default the same as detect(). Unless surfaces are refitted, a detection has only its type,
/// quadric, canonical form, score and inliers, which are samples, and the score is the share of all
/// samples or the confidence.
/// @param cloud  near the origin
/// @throws std::invalid_argument if an option is out of range
DetectionResult detect_printed(const PointCloud& cloud, const Settings& settings);

}  // namespace quadrille::printed
