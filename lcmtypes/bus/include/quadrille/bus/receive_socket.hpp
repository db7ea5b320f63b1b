#pragma once

#include <cstdint>
#include <optional>

#include "quadrille/bus/url.hpp"

namespace quadrille::bus {

/// The socket with which LCM receives datagrams in this process, to ask the kernel how it fares.
class ReceiveSocket {
 public:
  /// Looks for the UDP socket of this process that is bound to the port of a udpm address. LCM
  /// makes it with the first subscription.
  /// @return nullopt if there is none, and for other providers
  static std::optional<ReceiveSocket> find(const Url& url);

  /// Its receive buffer, as it is asked for: without what the kernel adds for itself [byte].
  std::int64_t buffer() const;

  /// Makes the buffer larger than net.core.rmem_max, where the process may; else nothing is done.
  void force_buffer(std::int64_t bytes);

  /// Datagrams dropped because the buffer was full; -1 where the kernel does not tell.
  std::int64_t dropped() const;

 private:
  explicit ReceiveSocket(int fd) : fd_(fd) {}

  int fd_;
};

}  // namespace quadrille::bus
