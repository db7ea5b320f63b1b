#include <new>

#include "byte_reader.hpp"
#include "quadrille/bus/grasps_message.hpp"

namespace quadrille::bus {
namespace {

/// A grasp: its target, track and kind, 34 doubles and a flag. A count and a warning: with empty
/// strings.
constexpr std::size_t kGraspBytes = 4 + 4 + 1 + 34 * 8 + 1, kMinCountBytes = 13,
                      kMinWarningBytes = 5;

/// Walks over all members; afterwards the generated decoder can allocate no more than a small
/// multiple of the bytes.
void check_grasps(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  if (reader.read_int64("the fingerprint") != grasps_t::getHash()) {
    refuse(RejectReason::kUnknownType, "not quadrille.grasps_t");
  }
  reader.read_int64("utime");
  reader.read_int64("request_id");
  reader.read_int32("seq");
  reader.read_string("frame", kMaxFrameBytes);
  reader.skip_string("gripper");
  reader.skip_string("unknown");
  const std::int32_t grasps = reader.read_count("num_grasps", kGraspBytes);
  reader.take(grasps, kGraspBytes, "grasps");
  const std::int32_t rejected = reader.read_count("num_rejected", kMinCountBytes);
  for (std::int32_t i = 0; i < rejected; ++i) {
    reader.skip_string("name");
    reader.read_int64("count");
  }
  const std::int32_t warnings = reader.read_count("num_warnings", kMinWarningBytes);
  for (std::int32_t i = 0; i < warnings; ++i) reader.skip_string("warning");
  reader.expect_end();
}

}  // namespace

Decoded<grasps_t> decode_grasps(std::span<const std::byte> bytes, std::size_t max_bytes) try {
  if (bytes.size() > max_bytes) {
    refuse(RejectReason::kTooLarge, std::to_string(bytes.size()) + " bytes");
  }
  check_grasps(bytes);
  grasps_t message;
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
