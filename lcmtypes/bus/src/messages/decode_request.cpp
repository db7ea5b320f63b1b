#include "messages/decode_checked.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/request_message.hpp"

namespace quadrille::bus {
namespace {

constexpr std::size_t kMaxTypeBytes = 64;
/// Size of the members after the types: flags and doubles of region, near, sizes, approach and
/// reach, clearance and score, two counts, the deadline, and a flag.
constexpr std::size_t kFixedBytes =
    (1 + 10 * 8) + (1 + 3 * 8) + 2 * 8 + (1 + 4 * 8) + (1 + 5 * 8) + 2 * 8 + 2 * 4 + 8 + 1;

void check_request(ByteReader& reader) {
  reader.read_int64("utime");
  if (reader.read_int64("request_id") == 0) {
    refuse(RejectReason::kBadValue, "request_id = 0, which answers to nobody carry");
  }
  reader.read_int64("cloud_utime");
  reader.read_string("frame", kMaxFrameBytes);
  reader.skip_array("targets", sizeof(std::int32_t));
  reader.skip_array("tracks", sizeof(std::int32_t));
  reader.skip_list("types", kMinStringBytes,
                   [](ByteReader& types) { types.read_string("types", kMaxTypeBytes); });
  reader.take(1, kFixedBytes, "region to advise");
}

}  // namespace

Decoded<grasp_request_t> decode_request(std::span<const std::byte> bytes) {
  return decode_checked<grasp_request_t>(bytes, kMaxRequestBytes, check_request);
}

}  // namespace quadrille::bus
