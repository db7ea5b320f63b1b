#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "quadrille/bus/url.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// The receive buffer that is advised for clouds of usual sizes, of which it holds a dozen [byte].
inline constexpr int kReceiveBufferBytes = 64 << 20;

/// The receive buffer that is asked for where the address names none [byte]. The kernel grants no
/// more than net.core.rmem_max, and takes no memory for what is not filled.
inline constexpr int kMaxReceiveBufferBytes = 128 << 20;

/// A cloud of 640x480 points as Drake sends it [byte].
inline constexpr std::int64_t kUsualCloudBytes = 640 * 480 * 16;

/// Why the multicast group of a udpm address cannot be reached, with the commands that mend it;
/// nullopt if a route exists, and for other providers.
/// @throws std::invalid_argument as multicast_group() does
QUADRILLE_EXPORT std::optional<std::string> find_route_problem(const Url& url);

/// The receive buffer without which messages of that size are lost sooner or later: it holds one
/// that comes while another is read [byte].
QUADRILLE_EXPORT std::int64_t needed_receive_buffer(std::int64_t message_bytes);

/// The receive buffer to set up for messages of that size, which holds a burst of them [byte].
QUADRILLE_EXPORT int advised_receive_buffer(std::int64_t message_bytes);

/// The commands that give the process a receive buffer.
/// @param asked   the size that the address asks for [byte]
/// @param wanted  the size that it is to have [byte]
QUADRILLE_EXPORT std::string mend_receive_buffer(std::int64_t asked, int wanted);

/// What is wrong with a receive buffer for messages of a size, with the commands that mend it;
/// nullopt if it will do.
/// @param asked          the size that the address asks for [byte]
/// @param granted        the size that the kernel grants [byte]
/// @param message_bytes  of the largest message [byte]
QUADRILLE_EXPORT std::optional<std::string> find_buffer_problem(std::int64_t asked,
                                                                std::int64_t granted,
                                                                std::int64_t message_bytes);

/// The same before any message came, foreseen for clouds of kUsualCloudBytes.
QUADRILLE_EXPORT std::optional<std::string> foresee_buffer_problem(std::int64_t asked,
                                                                   std::int64_t granted);

/// The receive buffer that the kernel grants to a UDP socket that asks for so much [byte].
/// @throws std::runtime_error if no socket can be made
QUADRILLE_EXPORT int granted_receive_buffer(int asked);

/// The same for a process that may exceed net.core.rmem_max (CAP_NET_ADMIN, as root has), and does.
/// @throws std::runtime_error if no socket can be made
QUADRILLE_EXPORT int forced_receive_buffer(int asked);

}  // namespace quadrille::bus
