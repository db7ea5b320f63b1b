#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace quadrille::bus {

/// The senders whose datagrams are accepted. Datagrams of this machine always are.
struct AcceptedSenders {
  /// Addresses that equal `address` in the bits of `mask`, both in the machine's byte order.
  struct Network {
    std::uint32_t address = 0, mask = 0;
  };
  std::vector<Network> networks;
  /// Names of the network interfaces on which any sender is accepted.
  std::vector<std::string> interfaces;
  /// True if no senders were named, so that all are accepted.
  bool all = true;
};

/// Reads a list such as "10.0.0.5,192.168.7.0/24,eth1" of addresses, networks and interfaces.
/// "local" accepts no other machine; an empty text accepts all.
/// @throws std::invalid_argument naming the item that is none of these
AcceptedSenders parse_senders(const std::string& text);

}  // namespace quadrille::bus
