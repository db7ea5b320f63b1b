#include <new>

#include "byte_reader.hpp"
#include "quadrille/bus/occupancy_message.hpp"

namespace quadrille::bus {

Decoded<occupancy_t> decode_occupancy(std::span<const std::byte> bytes, std::size_t max_bytes) try {
  if (bytes.size() > max_bytes) {
    refuse(RejectReason::kTooLarge, std::to_string(bytes.size()) + " bytes");
  }
  ByteReader reader(bytes);
  if (reader.read_int64("the fingerprint") != occupancy_t::getHash()) {
    refuse(RejectReason::kUnknownType, "not quadrille.occupancy_t");
  }
  reader.read_int64("utime");
  reader.read_int32("seq");
  reader.read_string("frame", kMaxFrameBytes);
  if (!(reader.read_finite("resolution") > 0.0)) {
    refuse(RejectReason::kBadValue, "resolution is not positive");
  }
  reader.read_int64("num_occupied");
  reader.read_int64("num_free");
  reader.take(reader.read_count("data_size", 1), 1, "data");
  reader.expect_end();
  occupancy_t message;
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
