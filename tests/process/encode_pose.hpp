#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <lcmtypes/bot_core/pose_t.hpp>
#include <vector>

#include "quadrille/bus/encode.hpp"

namespace quadrille::test {

/// A camera's pose as a message.
inline std::vector<std::byte> encode_pose(std::int64_t utime, const Eigen::Isometry3d& X_WK) {
  bot_core::pose_t m{};
  m.utime = utime;
  Eigen::Map<Eigen::Vector3d>(m.pos) = X_WK.translation();
  const Eigen::Quaterniond q(X_WK.linear());
  m.orientation[0] = q.w(), m.orientation[1] = q.x();
  m.orientation[2] = q.y(), m.orientation[3] = q.z();
  return bus::encode(m);
}

}  // namespace quadrille::test
