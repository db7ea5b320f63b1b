#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "link/url.hpp"

namespace quadrille::bus {

/// Returns the descriptors, in ascending order, of this process's UDP sockets that are bound to the
/// port of a udpm address. LCM makes its socket with the first subscription and does not expose it,
/// so it is found as the one that was not there before.
std::vector<int> find_receiving_sockets(const Url& url);

/// The socket on which LCM receives datagrams in this process, to query its state from the kernel.
class ReceiveSocket {
 public:
  /// @param fd  the socket's descriptor, which must stay open as long as this lives
  explicit ReceiveSocket(int fd) : fd_(fd) {}

  int descriptor() const { return fd_; }

  /// Size of the receive buffer as it is requested, without the kernel's own overhead [byte].
  std::int64_t buffer() const;

  /// Makes the buffer larger than net.core.rmem_max if the process may; otherwise does nothing.
  void force_buffer(std::int64_t bytes);

  /// Number of datagrams dropped because the buffer was full or a filter refused them; -1 if the
  /// kernel does not tell.
  std::int64_t dropped() const;

 private:
  int fd_;
};

}  // namespace quadrille::bus
