#include "quadrille/bus/status_message.hpp"

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

}  // namespace quadrille::bus
