#pragma once

#include "link/accepted_senders.hpp"

namespace quadrille::bus {

/// Makes the kernel drop datagrams that LCM must not see before anyone reads them:
///  - datagrams that crash LCM 1.3 to 1.5: a fragment that lies outside its message, a first
///    fragment that does not begin it, or a channel name without an end;
///  - datagrams of senders that are not accepted.
/// A datagram counts as local if it came by loopback, whatever its source address, which can be
/// forged.
/// @throws std::runtime_error if an interface does not exist or the kernel refuses the filter
void guard_socket(int socket, const AcceptedSenders& senders);

}  // namespace quadrille::bus
