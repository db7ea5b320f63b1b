#include "messages/decode_checked.hpp"
#include "quadrille/bus/occupancy_message.hpp"

namespace quadrille::bus {
namespace {

void check_occupancy(ByteReader& reader) {
  reader.read_int64("utime");
  reader.read_int32("seq");
  reader.read_string("frame", kMaxFrameBytes);
  if (!(reader.read_finite("resolution") > 0.0)) {
    refuse(RejectReason::kBadValue, "resolution is not positive");
  }
  reader.read_int64("num_occupied");
  reader.read_int64("num_free");
  reader.skip_array("data", 1);
}

}  // namespace

Decoded<occupancy_t> decode_occupancy(std::span<const std::byte> bytes, std::size_t max_bytes) {
  return decode_checked<occupancy_t>(bytes, max_bytes, check_occupancy);
}

}  // namespace quadrille::bus
