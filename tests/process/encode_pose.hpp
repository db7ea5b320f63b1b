#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadrille/bus/pose_message.hpp"

namespace quadrille::test {

/// A camera's pose as a message.
inline std::vector<std::byte> encode_pose(std::int64_t utime, const Eigen::Isometry3d& X_WK) {
  return bus::encode_pose({utime, X_WK});
}

}  // namespace quadrille::test
