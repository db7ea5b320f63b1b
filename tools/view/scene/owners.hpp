#pragma once

#include <cstdint>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::view {

/// Returns at most `max_points` points of a cloud, evenly spread: every n-th one, or of an
/// organised cloud every n-th of every n-th row. Missing points are left out. `colours` receives
/// the colours of these points, if the cloud has any.
std::vector<Eigen::Vector3f> thin_out(const PointCloud& cloud, std::size_t max_points,
                                      std::vector<Rgb>* colours = nullptr);

/// Returns for each point the number, from 1 on, of the detection on whose surface it lies; 0 for
/// none, and the nearest if several would do. Only the first 255 detections are considered.
std::vector<std::uint8_t> owners_of(const std::vector<Eigen::Vector3f>& points,
                                    const std::vector<Detection>& detections);

}  // namespace quadrille::view
