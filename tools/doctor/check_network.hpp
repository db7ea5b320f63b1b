#pragma once

#include <cstdint>
#include <string>

#include "doctor/finding.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille::doctor {

/// What to do about an address that cannot work.
inline constexpr const char* kMendAddress =
    "--lcm-url 'udpm://239.255.76.67:7667?ttl=0', or unset LCM_DEFAULT_URL";

/// Whether the address is one over which processes hear each other.
Finding check_address(const bus::Url& url);

/// Whether a route leads to the multicast group of a udpm address.
Finding check_route(const bus::Url& url);

/// By which interface messages leave, and whether it carries multicast.
Finding check_interface(const bus::Url& url);

/// How far messages go.
Finding check_ttl(const bus::Url& url);

/// The buffers of a socket.
struct Buffers {
  /// What is asked for, what the kernel grants this process, and what one without privileges
  /// [byte].
  int asked = 0, granted = 0, unprivileged = 0;
};

/// Those that a process with this address gets.
Buffers buffers_of(const bus::Url& url);

/// Whether clouds of that size fit.
/// @param cloud_bytes  a message with a cloud [byte]
/// @param source       how that size is known, such as "seen on the bus"
Finding check_buffers(const Buffers& buffers, std::int64_t cloud_bytes, const std::string& source);

}  // namespace quadrille::doctor
