#pragma once

#include <netinet/in.h>

#include <map>
#include <optional>
#include <string>

namespace quadrille::bus {

/// An LCM address: provider://network?key=value&key=value.
struct Url {
  std::string provider, network;
  std::map<std::string, std::string> arguments;

  /// The address as LCM reads it, with its arguments sorted by key.
  std::string to_string() const;
};

/// Parses an address; if an argument is given twice, the last one counts.
/// @throws std::invalid_argument if there is no "provider://"
Url parse_url(const std::string& text);

/// The multicast group and port of a udpm address, or LCM's defaults if it names none.
/// @throws std::invalid_argument if it is not ADDRESS:PORT, or not a multicast address
sockaddr_in multicast_group(const Url& url);

/// The receive buffer that an address requests [byte]; nullopt if it names none.
/// @throws std::invalid_argument if its value is not a number of bytes from 1 to the largest int
std::optional<int> named_receive_buffer(const Url& url);

/// Refuses addresses at which a process can never hear or be heard, whatever the network: providers
/// that reach no other process, addresses that are no multicast group, and arguments out of range,
/// about which LCM itself says nothing.
/// @throws std::invalid_argument that says what to give instead
void check_live(const Url& url);

/// The address to use: the option if it is not empty, otherwise $LCM_DEFAULT_URL if it is set and
/// not empty, otherwise LCM's own default, for this machine only (ttl=0).
std::string resolve_url(const std::string& option);

}  // namespace quadrille::bus
