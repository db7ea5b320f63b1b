#pragma once

#include <netinet/in.h>

#include <map>
#include <optional>
#include <string>

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// An LCM address: provider://network?key=value&key=value.
struct Url {
  std::string provider, network;
  std::map<std::string, std::string> arguments;

  /// The address as LCM reads it, its arguments in the order of their keys.
  QUADRILLE_EXPORT std::string to_string() const;
};

/// Takes an address apart; of an argument that is given twice the last one counts.
/// @throws std::invalid_argument if there is no "provider://"
QUADRILLE_EXPORT Url parse_url(const std::string& text);

/// The multicast group and port of a udpm address; LCM's own where it names none.
/// @throws std::invalid_argument if it is not ADDRESS:PORT, or no multicast address
QUADRILLE_EXPORT sockaddr_in multicast_group(const Url& url);

/// The receive buffer that an address asks for [byte]; nullopt if it names none.
/// @throws std::invalid_argument if that is no number of bytes from 1 to the largest int
QUADRILLE_EXPORT std::optional<int> named_receive_buffer(const Url& url);

/// Refuses addresses at which a process hears nobody, or is heard by nobody, whatever the network:
/// those of providers that reach no other process, of no multicast group, or with arguments out of
/// range, of which LCM says nothing.
/// @throws std::invalid_argument that says what to give instead
QUADRILLE_EXPORT void check_live(const Url& url);

/// The address to use: the option if it is not empty, else $LCM_DEFAULT_URL if it is set and not
/// empty, else LCM's own default, this machine only (ttl=0).
QUADRILLE_EXPORT std::string resolve_url(const std::string& option);

}  // namespace quadrille::bus
