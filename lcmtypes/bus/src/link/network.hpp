#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "link/url.hpp"

namespace quadrille::bus {

/// Recommended receive buffer for clouds of usual sizes, of which it holds a dozen [byte].
inline constexpr int kReceiveBufferBytes = 64 << 20;

/// Receive buffer that is requested if the address names none [byte]. The kernel grants at most
/// net.core.rmem_max, and uses no memory for the unfilled part.
inline constexpr int kMaxReceiveBufferBytes = 128 << 20;

/// Size of a cloud of 640x480 points as Drake sends it [byte].
inline constexpr std::int64_t kUsualCloudBytes = std::int64_t{640} * 480 * 16;

/// Explains why the multicast group of a udpm address cannot be reached, with the commands that
/// mend it; nullopt if a route exists, and for other providers.
/// @throws std::invalid_argument like multicast_group()
std::optional<std::string> find_route_problem(const Url& url);

/// Least receive buffer for messages of the given size [byte]. It holds one message that arrives
/// while another is read; with less, messages are lost sooner or later.
std::int64_t needed_receive_buffer(std::int64_t message_bytes);

/// Recommended receive buffer for messages of the given size, which holds a burst of them [byte].
int advised_receive_buffer(std::int64_t message_bytes);

/// Returns the commands that give the process a receive buffer.
/// @param asked   size that the address requests [byte]
/// @param wanted  size that it should have [byte]
std::string mend_receive_buffer(std::int64_t asked, int wanted);

/// Explains why a receive buffer is too small for messages of a size, with the commands that mend
/// it; nullopt if it suffices.
/// @param asked          size that the address requests [byte]
/// @param granted        size that the kernel grants [byte]
/// @param message_bytes  size of the largest message [byte]
std::optional<std::string> find_buffer_problem(std::int64_t asked, std::int64_t granted,
                                               std::int64_t message_bytes);

/// Calls find_buffer_problem() before any message came, for clouds of kUsualCloudBytes.
std::optional<std::string> foresee_buffer_problem(std::int64_t asked, std::int64_t granted);

/// Receive buffer that the kernel grants to a UDP socket that requests `asked` bytes [byte].
/// @throws std::runtime_error if no socket can be made
int granted_receive_buffer(int asked);

/// Receive buffer that a process gets if it may exceed net.core.rmem_max (CAP_NET_ADMIN, as root
/// has) and does [byte].
/// @throws std::runtime_error if no socket can be made
int forced_receive_buffer(int asked);

}  // namespace quadrille::bus
