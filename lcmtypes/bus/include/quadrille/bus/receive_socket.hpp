#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "quadrille/bus/url.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// The descriptors of this process's UDP sockets that are bound to the port of a udpm address, in
/// ascending order. LCM makes one with the first subscription, and keeps it to itself: it is the
/// one that was not there before.
QUADRILLE_EXPORT std::vector<int> find_receiving_sockets(const Url& url);

/// The socket with which LCM receives datagrams in this process, to ask the kernel how it fares.
class ReceiveSocket {
 public:
  /// @param fd  its descriptor, which stays open for longer than this lives
  explicit ReceiveSocket(int fd) : fd_(fd) {}

  int descriptor() const { return fd_; }

  /// Its receive buffer, as it is asked for: without what the kernel adds for itself [byte].
  QUADRILLE_EXPORT std::int64_t buffer() const;

  /// Makes the buffer larger than net.core.rmem_max, where the process may; else nothing is done.
  QUADRILLE_EXPORT void force_buffer(std::int64_t bytes);

  /// Datagrams dropped because the buffer was full or a filter refused them; -1 where the kernel
  /// does not tell.
  QUADRILLE_EXPORT std::int64_t dropped() const;

 private:
  int fd_;
};

}  // namespace quadrille::bus
