#include "link/accepted_senders.hpp"

#include <arpa/inet.h>
#include <net/if.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>

#include "quadrille/detector/printable.hpp"

namespace quadrille::bus {
namespace {

/// Reads the number of leading one bits of a mask, as written after the slash; nullopt if it is not
/// a number from 0 to 32.
std::optional<std::uint32_t> read_mask(const std::string& text) {
  unsigned bits = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, bits);
  if (error != std::errc{} || rest != end || bits > 32) return std::nullopt;
  return bits == 0 ? 0 : ~std::uint32_t{0} << (32 - bits);
}

std::optional<AcceptedSenders::Network> read_network(const std::string& item) {
  const std::size_t slash = item.find('/');
  in_addr address = {};
  if (inet_pton(AF_INET, item.substr(0, slash).c_str(), &address) != 1) return std::nullopt;
  const auto mask = read_mask(slash == std::string::npos ? "32" : item.substr(slash + 1));
  if (!mask) return std::nullopt;
  return AcceptedSenders::Network{ntohl(address.s_addr) & *mask, *mask};
}

bool can_be_interface(const std::string& item) {
  const bool starts_with_letter =
      !item.empty() && ((item[0] >= 'a' && item[0] <= 'z') || (item[0] >= 'A' && item[0] <= 'Z'));
  return starts_with_letter && item.size() < IF_NAMESIZE &&
         item.find_first_of("/ \t") == std::string::npos;
}

void add_item(const std::string& item, AcceptedSenders* senders) {
  if (item == "local") return;
  if (const auto network = read_network(item)) {
    senders->networks.push_back(*network);
  } else if (can_be_interface(item)) {
    senders->interfaces.push_back(item);
  } else {
    throw std::invalid_argument("'" + printable(item) +
                                "' is no sender: give addresses, networks such as 10.0.0.0/24, "
                                "interfaces or the word local, with commas between");
  }
}

}  // namespace

AcceptedSenders parse_senders(const std::string& text) {
  AcceptedSenders senders;
  if (text.empty()) return senders;
  senders.all = false;
  // The filter program in the kernel grows with the list; this many items keep it far below its
  // limit.
  constexpr std::ptrdiff_t kMaxItems = 256;
  if (std::count(text.begin(), text.end(), ',') >= kMaxItems) {
    throw std::invalid_argument("more than 256 senders: name networks instead");
  }
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    add_item(text.substr(start, end - start), &senders);
    start = end + 1;
  }
  return senders;
}

}  // namespace quadrille::bus
