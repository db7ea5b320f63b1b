#include "quadrille/bus/status_message.hpp"

#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/planner_status_t.hpp>

#include "byte_reader.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::bus {

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

}  // namespace quadrille::bus
