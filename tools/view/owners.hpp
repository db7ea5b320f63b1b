#pragma once

#include <cstdint>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::view {

/// The most points of a cloud that are shown, evenly spread: every n-th one, or of an organised
/// cloud every n-th of every n-th row. Missing points are left out. `colours` are those of the
/// points that are shown, if the cloud has any.
std::vector<Eigen::Vector3f> thin_out(const PointCloud& cloud, std::size_t max_points,
                                      std::vector<Rgb>* colours = nullptr);

/// For each point the detection on whose surface it lies, as its place from 1 on; 0 for none. Where
/// several would do, the nearest. No more than 255 detections are looked at.
std::vector<std::uint8_t> owners_of(const std::vector<Eigen::Vector3f>& points,
                                    const std::vector<Detection>& detections);

}  // namespace quadrille::view
