#pragma once

#include <cstdint>
#include <string>

#include "doctor/finding.hpp"
#include "link/url.hpp"

namespace quadrille::doctor {

/// The remedy for an address that cannot work.
inline constexpr const char* kMendAddress =
    "--lcm-url 'udpm://239.255.76.67:7667?ttl=0', or unset LCM_DEFAULT_URL";

/// Checks that processes can hear each other over the address.
Finding check_address(const bus::Url& url);

/// Checks that a route leads to the multicast group of a udpm address.
Finding check_route(const bus::Url& url);

/// Checks by which interface messages leave, and whether it supports multicast.
Finding check_interface(const bus::Url& url);

/// Checks how far messages travel.
Finding check_ttl(const bus::Url& url);

/// The sizes of a socket's receive buffer.
struct Buffers {
  /// Size that is requested, size that the kernel grants this process, and size that it grants a
  /// process without privileges [byte].
  int asked = 0, granted = 0, unprivileged = 0;
};

/// Returns the buffers that a process with this address gets.
Buffers buffers_of(const bus::Url& url);

/// Checks that clouds of this size fit into the buffers.
/// @param cloud_bytes  size of a message with a cloud [byte]
/// @param source       how that size is known, such as "seen on the bus"
Finding check_buffers(const Buffers& buffers, std::int64_t cloud_bytes, const std::string& source);

}  // namespace quadrille::doctor
