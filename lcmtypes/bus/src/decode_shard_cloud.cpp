#include "byte_reader.hpp"
#include "quadrille/bus/shard_message.hpp"

namespace quadrille::bus {
namespace {

shard_cloud_t read_shard_cloud(ByteReader& reader) {
  if (reader.read_int64("the fingerprint") != shard_cloud_t::getHash()) {
    refuse(RejectReason::kUnknownType, "not quadrille.shard_cloud_t");
  }
  shard_cloud_t message;
  message.utime = reader.read_int64("utime");
  message.seq = reader.read_int32("seq");
  message.message_digest = reader.read_int64("message_digest");
  message.cloud_digest = reader.read_int64("cloud_digest");
  message.shard = reader.read_int32("shard");
  message.shards = reader.read_int32("shards");
  message.sender = reader.read_int64("sender");
  reader.expect_end();
  if (message.shard < 1 || message.shards < message.shard) {
    refuse(RejectReason::kBadValue,
           "shard " + std::to_string(message.shard) + " of " + std::to_string(message.shards));
  }
  return message;
}

}  // namespace

Decoded<shard_cloud_t> decode_shard_cloud(std::span<const std::byte> bytes) try {
  ByteReader reader(bytes);
  return read_shard_cloud(reader);
} catch (const Refused& refused) {
  return refused.rejection;
}

}  // namespace quadrille::bus
