#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Whose datagrams are let in. This machine's own always are.
struct AcceptedSenders {
  /// Addresses whose bits under the mask are these, in the machine's byte order.
  struct Network {
    std::uint32_t address = 0, mask = 0;
  };
  std::vector<Network> networks;
  /// Names of interfaces by which they may come.
  std::vector<std::string> interfaces;
  /// True if nothing is told of senders: all are let in.
  bool all = true;
};

/// Reads "10.0.0.5,192.168.7.0/24,eth1": addresses, networks and interfaces. "local" names no other
/// machine; an empty text lets all in.
/// @throws std::invalid_argument naming the item that is none of these
QUADRILLE_EXPORT AcceptedSenders parse_senders(const std::string& text);

}  // namespace quadrille::bus
