#include "decode_checked.hpp"
#include "quadrille/bus/grasps_message.hpp"

namespace quadrille::bus {
namespace {

/// Sizes of a grasp (its target, track and kind, 34 doubles and a flag), and of a count and a
/// warning with empty strings.
constexpr std::size_t kGraspBytes = 4 + 4 + 1 + 34 * 8 + 1, kMinCountBytes = 13,
                      kMinWarningBytes = 5;

void check_grasps(ByteReader& reader) {
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
}

}  // namespace

Decoded<grasps_t> decode_grasps(std::span<const std::byte> bytes, std::size_t max_bytes) {
  return decode_checked<grasps_t>(bytes, max_bytes, check_grasps);
}

}  // namespace quadrille::bus
