#pragma once

#include <array>
#include <limits>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::test {

/// Depths that drivers send for pixels without a measurement, also with a negative sign.
inline constexpr std::array kMissingCodes = {1e30f,
                                             std::numeric_limits<float>::max(),
                                             1e22f,
                                             1e23f,
                                             1e5f,
                                             -1e30f,
                                             std::numeric_limits<float>::lowest(),
                                             std::numeric_limits<float>::infinity(),
                                             -std::numeric_limits<float>::infinity()};

/// The cloud with a number for some pixels, alone and in a block: for all coordinates of every
/// other one, and as depth along the ray of the others.
inline PointCloud with_code(PointCloud cloud, float code) {
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (i % 97 != 0 && (i < 9000 || i >= 9060)) continue;
    Eigen::Vector3f& p = cloud.points[i];
    p = i % 2 && p.allFinite() ? Eigen::Vector3f(code * (p / p.z()))
                               : Eigen::Vector3f::Constant(code);
  }
  return cloud;
}

/// The same cloud with NaN in place of these pixels.
inline PointCloud with_gaps(PointCloud cloud) {
  return with_code(std::move(cloud), std::numeric_limits<float>::quiet_NaN());
}

/// The points of an organised cloud as a list, of which missing ones are dropped.
inline PointCloud as_list(PointCloud cloud) {
  cloud.width = cloud.height = 0;
  std::erase_if(cloud.points, [](const Eigen::Vector3f& p) { return p.hasNaN(); });
  return cloud;
}

}  // namespace quadrille::test
