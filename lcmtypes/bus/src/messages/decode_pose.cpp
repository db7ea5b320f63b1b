#include <cmath>
#include <lcmtypes/bot_core/pose_t.hpp>

#include "messages/byte_reader.hpp"
#include "quadrille/bus/pose_message.hpp"

namespace quadrille::bus {
namespace {

PoseMessage read_pose(ByteReader& reader) {
  if (reader.read_int64("the fingerprint") != bot_core::pose_t::getHash()) {
    refuse(RejectReason::kUnknownType, "not bot_core.pose_t");
  }
  PoseMessage message;
  message.utime = reader.read_int64("utime");
  for (int i = 0; i < 3; ++i) message.X_WC.translation()[i] = reader.read_finite("pos");
  // Drivers that do not measure motion may fill it with anything.
  for (int i = 0; i < 3; ++i) reader.read_double("vel");
  const double w = reader.read_finite("orientation"), x = reader.read_finite("orientation");
  const double y = reader.read_finite("orientation"), z = reader.read_finite("orientation");
  for (int i = 0; i < 6; ++i) reader.read_double("rotation_rate and accel");
  reader.expect_end();
  const Eigen::Quaterniond R_WC(w, x, y, z);
  if (!(std::abs(R_WC.norm() - 1.0) < 1e-3)) {
    refuse(RejectReason::kBadValue, "orientation is not of unit norm");
  }
  message.X_WC.linear() = R_WC.normalized().toRotationMatrix();
  return message;
}

}  // namespace

Decoded<PoseMessage> decode_pose(std::span<const std::byte> bytes) try {
  ByteReader reader(bytes);
  return read_pose(reader);
} catch (const Refused& refused) {
  return refused.rejection;
}

}  // namespace quadrille::bus
