#include <new>

#include "byte_reader.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/request_message.hpp"

namespace quadrille::bus {
namespace {

constexpr std::size_t kIntegerBytes = 4, kMinTypeBytes = 5, kMaxTypeBytes = 64;
/// After the types: the flags and doubles of region, near, sizes, approach and clearance, and a
/// count.
constexpr std::size_t kFixedBytes = (1 + 10 * 8) + (1 + 3 * 8) + 2 * 8 + (1 + 4 * 8) + 8 + 4;

/// Walks over all members; afterwards the generated decoder can allocate no more than a small
/// multiple of the bytes.
void check_request(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  if (reader.read_int64("the fingerprint") != grasp_request_t::getHash()) {
    refuse(RejectReason::kUnknownType, "not quadrille.grasp_request_t");
  }
  reader.read_int64("utime");
  if (reader.read_int64("request_id") == 0) {
    refuse(RejectReason::kBadValue, "request_id = 0, which answers to nobody carry");
  }
  reader.read_int64("cloud_utime");
  reader.read_string("frame", kMaxFrameBytes);
  reader.take(reader.read_count("num_targets", kIntegerBytes), kIntegerBytes, "targets");
  reader.take(reader.read_count("num_tracks", kIntegerBytes), kIntegerBytes, "tracks");
  const std::int32_t types = reader.read_count("num_types", kMinTypeBytes);
  for (std::int32_t i = 0; i < types; ++i) reader.read_string("types", kMaxTypeBytes);
  reader.take(1, kFixedBytes, "region to max_grasps");
  reader.expect_end();
}

}  // namespace

Decoded<grasp_request_t> decode_request(std::span<const std::byte> bytes) try {
  if (bytes.size() > kMaxRequestBytes) {
    refuse(RejectReason::kTooLarge, std::to_string(bytes.size()) + " bytes");
  }
  check_request(bytes);
  grasp_request_t message;
  const int size = static_cast<int>(bytes.size());
  if (message.decode(bytes.data(), 0, size) != size) {
    refuse(RejectReason::kBadLength, "the decoder reads another size");
  }
  return message;
} catch (const Refused& refused) {
  return refused.rejection;
} catch (const std::bad_alloc&) {
  return Rejection{RejectReason::kInternal, "out of memory"};
}

}  // namespace quadrille::bus
