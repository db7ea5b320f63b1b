#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/bot_core/pointcloud_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>

#include "byte_reader.hpp"
#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::bus {

std::optional<CloudStamp> read_stamp(std::span<const std::byte> bytes) try {
  ByteReader reader(bytes);
  const std::int64_t fingerprint = reader.read_int64("the fingerprint");
  const bool has_seq = fingerprint == bot_core::pointcloud2_t::getHash() ||
                       fingerprint == bot_core::pointcloud_t::getHash();
  if (!has_seq && fingerprint != drake::lcmt_point_cloud::getHash()) return std::nullopt;
  CloudStamp stamp;
  stamp.utime = reader.read_int64("utime");
  if (has_seq) stamp.seq = reader.read_int32("seq");
  return stamp;
} catch (const Refused&) {
  return std::nullopt;
}

}  // namespace quadrille::bus
