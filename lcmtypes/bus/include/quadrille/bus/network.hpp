#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "quadrille/bus/url.hpp"

namespace quadrille::bus {

/// The receive buffer that is asked for where the address names none [byte].
inline constexpr int kReceiveBufferBytes = 32 << 20;

/// Why the multicast group of a udpm address cannot be reached, with the commands that mend it;
/// nullopt if a route exists, and for other providers.
/// @throws std::invalid_argument if the network part is not "address:port"
std::optional<std::string> find_route_problem(const Url& url);

/// What is wrong with a receive buffer for a cloud of 640x480 points (some 5 MB), with the commands
/// that mend it; nullopt if it will do.
/// @param asked    the size that the address asks for [byte]
/// @param granted  the size that the kernel grants [byte]
std::optional<std::string> find_buffer_problem(int asked, int granted);

/// The receive buffer that the kernel grants to a UDP socket that asks for so much [byte].
/// @throws std::runtime_error if no socket can be made
int granted_receive_buffer(int asked);

/// UDP datagrams that this machine dropped since its start because a receive buffer was full;
/// -1 where the system does not tell.
std::int64_t count_dropped_datagrams();

}  // namespace quadrille::bus
