#include "quadrille/bus/status_message.hpp"

#include "messages/decode_checked.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::bus {
namespace {

/// Larger messages are refused [byte]. A status consists mostly of warnings, which are a few lines
/// of text.
constexpr std::size_t kMaxStatusBytes = std::size_t{1} << 20;
/// Sizes of transport_t, of the members of process_t after its strings, and of those of stage_t
/// after its name.
constexpr std::int64_t kTransportBytes = 48, kProcessNumbersBytes = 40, kStageNumbersBytes = 48;

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
    reader.take(1, kTransportBytes, "transport");
    reader.skip_string("version");
    reader.skip_string("settings");
    reader.take(1, kProcessNumbersBytes, "process");
    for (int i = 0; i < lists_of_counts; ++i) reader.skip_counts("counts");
    reader.skip_list("stages", kMinStringBytes + kStageNumbersBytes, [](ByteReader& stage) {
      stage.skip_string("name");
      stage.take(1, kStageNumbersBytes, "stage");
    });
    reader.skip_strings("warnings");
  });
}

}  // namespace

std::vector<count_t> to_message(const RejectCounts& counts) {
  std::vector<count_t> message;
  for (const RejectReason reason : all_reject_reasons()) {
    if (counts.of(reason) == 0) continue;
    count_t entry;
    entry.name = to_string(reason);
    entry.count = counts.of(reason);
    message.push_back(entry);
  }
  return message;
}

std::optional<std::string> read_status_sender(std::span<const std::byte> bytes) try {
  constexpr std::size_t kMaxSenderBytes = 128;
  ByteReader reader(bytes);
  const std::int64_t fingerprint = reader.read_int64("the fingerprint");
  if (fingerprint != detector_status_t::getHash() && fingerprint != planner_status_t::getHash()) {
    return std::nullopt;
  }
  reader.read_int64("utime");
  return printable(reader.read_string("sender", kMaxSenderBytes));
} catch (const Refused&) {
  return std::nullopt;
}

Decoded<detector_status_t> decode_detector_status(std::span<const std::byte> bytes) {
  return decode<detector_status_t>(bytes, 15, 5);
}

Decoded<planner_status_t> decode_planner_status(std::span<const std::byte> bytes) {
  return decode<planner_status_t>(bytes, 23, 9);
}

}  // namespace quadrille::bus
