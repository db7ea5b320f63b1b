#include <algorithm>
#include <lcmtypes/bot_core/pose_t.hpp>

#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/pose_message.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::bus {

std::vector<std::byte> encode_pose(const PoseMessage& message) {
  bot_core::pose_t m{};
  m.utime = message.utime;
  const Eigen::Vector3d position = message.X_WC.translation();
  std::copy_n(position.data(), 3, m.pos);
  const Eigen::Quaterniond R_WC = rotation_of(message.X_WC);
  m.orientation[0] = R_WC.w();
  m.orientation[1] = R_WC.x();
  m.orientation[2] = R_WC.y();
  m.orientation[3] = R_WC.z();
  return encode(m);
}

}  // namespace quadrille::bus
