#include "decode_checked.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille::bus {
namespace {

/// Larger messages are refused [byte]. A status consists mostly of warnings, which are a few lines
/// of text.
constexpr std::size_t kMaxStatusBytes = std::size_t{1} << 20;
/// Sizes of transport_t, of the members of process_t after its strings, and of those of stage_t
/// after its name.
constexpr std::int64_t kTransportBytes = 6 * 8, kProcessNumbersBytes = 4 * 8 + 2 * 4,
                       kStageNumbersBytes = 6 * 8;

void skip_counts(ByteReader& reader) {
  const std::int32_t counts = reader.read_count("counts", kMinStringBytes + 8);
  for (std::int32_t i = 0; i < counts; ++i) {
    reader.skip_string("name");
    reader.read_int64("count");
  }
}

/// Walks over the members from the transport on, with a number of lists of counts between.
void skip_tail(ByteReader& reader, int lists_of_counts) {
  reader.take(1, kTransportBytes, "transport");
  reader.skip_string("version");
  reader.skip_string("settings");
  reader.take(1, kProcessNumbersBytes, "process");
  for (int i = 0; i < lists_of_counts; ++i) skip_counts(reader);
  const std::int32_t stages = reader.read_count("num_stages", kMinStringBytes + kStageNumbersBytes);
  for (std::int32_t i = 0; i < stages; ++i) {
    reader.skip_string("name");
    reader.take(1, kStageNumbersBytes, "stage");
  }
  const std::int32_t warnings = reader.read_count("num_warnings", kMinStringBytes);
  for (std::int32_t i = 0; i < warnings; ++i) reader.skip_string("warning");
}

/// Checks and decodes a status message.
/// @param numbers          number of 64-bit values between the sender and the transport
/// @param lists_of_counts  number of lists between the process and the stages
template <class Status>
Decoded<Status> decode(std::span<const std::byte> bytes, std::int64_t numbers,
                       int lists_of_counts) {
  return decode_checked<Status>(bytes, kMaxStatusBytes, [&](ByteReader& reader) {
    reader.read_int64("utime");
    reader.skip_string("sender");
    reader.take(numbers, 8, "numbers");
    skip_tail(reader, lists_of_counts);
  });
}

}  // namespace

Decoded<detector_status_t> decode_detector_status(std::span<const std::byte> bytes) {
  return decode<detector_status_t>(bytes, 12, 2);
}

Decoded<planner_status_t> decode_planner_status(std::span<const std::byte> bytes) {
  return decode<planner_status_t>(bytes, 20, 6);
}

}  // namespace quadrille::bus
