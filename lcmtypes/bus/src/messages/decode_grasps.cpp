#include "messages/decode_checked.hpp"
#include "quadrille/bus/grasps_message.hpp"

namespace quadrille::bus {
namespace {

/// Size of a grasp: its target, track and kind, 34 doubles and a flag.
constexpr std::size_t kGraspBytes = 4 + 4 + 1 + 34 * 8 + 1;

/// Size of an outcome without refusals: two numbers, a string and the number of refusals.
constexpr std::size_t kMinOutcomeBytes = 4 + 4 + kMinStringBytes + 4;

/// Size of a remedy: two numbers, a string and the score.
constexpr std::size_t kMinRemedyBytes = 4 + kMinStringBytes + 4 + 8;

/// Size of a view that helps no body: its pose, the number of bodies and the gain.
constexpr std::size_t kMinLookBytes = kPoseBytes + 4 + 8;

void skip_outcome(ByteReader& reader) {
  reader.read_int32("target");
  reader.read_int32("num_grasps");
  reader.skip_string("furthest");
  reader.skip_counts("rejected");
}

void skip_remedy(ByteReader& reader) {
  reader.read_int32("target");
  reader.skip_string("change");
  reader.take(1, 4 + 8, "num_grasps to score");
}

void check_look(ByteReader& reader) {
  reader.skip_pose();
  reader.skip_array("bodies", sizeof(std::int32_t));
  reader.read_finite("gain");
}

void check_grasps(ByteReader& reader) {
  reader.read_int64("utime");
  reader.read_int64("request_id");
  reader.read_int32("seq");
  reader.read_string("frame", kMaxFrameBytes);
  reader.skip_string("gripper");
  reader.skip_string("unknown");
  reader.skip_array("grasps", kGraspBytes);
  reader.skip_counts("rejected");
  reader.skip_list("targets", kMinOutcomeBytes, skip_outcome);
  reader.skip_list("remedies", kMinRemedyBytes, skip_remedy);
  reader.skip_list("looks", kMinLookBytes, check_look);
  reader.skip_strings("warnings");
}

}  // namespace

Decoded<grasps_t> decode_grasps(std::span<const std::byte> bytes, std::size_t max_bytes) {
  return decode_checked<grasps_t>(bytes, max_bytes, check_grasps);
}

}  // namespace quadrille::bus
