#pragma once

#include "quadrille/bus/accepted_senders.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Has the kernel drop, before anyone reads them, datagrams that LCM must not see:
///  - those that LCM 1.3 to 1.5 dies of: a fragment that lies outside its message, a first fragment
///    that does not begin it, or the name of a channel without an end;
///  - those of senders that are not accepted.
/// A datagram cannot pass for one of this machine by its address: that is told by how it came.
/// @throws std::runtime_error if an interface does not exist or the kernel refuses the filter
QUADRILLE_EXPORT void guard_socket(int socket, const AcceptedSenders& senders);

}  // namespace quadrille::bus
