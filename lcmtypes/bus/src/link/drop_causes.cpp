#include "link/drop_causes.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace quadrille::bus {

std::optional<UdpErrors> read_udp_errors() {
  std::ifstream snmp("/proc/net/snmp");
  std::string names, values;
  while (std::getline(snmp, names) && std::getline(snmp, values)) {
    if (!names.starts_with("Udp:")) continue;
    std::istringstream name_words(names), value_words(values);
    std::map<std::string, std::int64_t> counts;
    std::string name, value;
    name_words >> name, value_words >> value;
    for (std::int64_t count = 0; name_words >> name && value_words >> count;) counts[name] = count;
    if (!counts.contains("InErrors") || !counts.contains("RcvbufErrors")) return std::nullopt;
    // MemErrors are counted too: the sockets of the whole machine may have no memory left for
    // buffers.
    return UdpErrors{counts["InErrors"], counts["RcvbufErrors"] + counts["MemErrors"]};
  }
  return std::nullopt;
}

void DropCauses::update(std::optional<UdpErrors> before, std::uint32_t dropped,
                        std::optional<UdpErrors> after) {
  const auto start = std::exchange(before_, before);
  const std::int64_t fresh = dropped - std::exchange(dropped_, dropped);
  if (fresh == 0) return;
  std::int64_t most_buffer = fresh, most_filtered = fresh;
  if (start && after) {
    // The counts span from before the socket's previous count to after the present one, so they are
    // no less than what the socket dropped in between.
    const std::int64_t buffer = after->buffer - start->buffer;
    most_buffer = std::clamp<std::int64_t>(buffer, 0, fresh);
    most_filtered = std::clamp<std::int64_t>(after->all - start->all - buffer, 0, fresh);
  }
  if (most_buffer + most_filtered < fresh) most_buffer = most_filtered = fresh;
  drops_.buffer += fresh - most_filtered;
  drops_.filtered += fresh - most_buffer;
  drops_.unclear += most_buffer + most_filtered - fresh;
}

}  // namespace quadrille::bus
