#pragma once

#include <cstdint>
#include <optional>

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// UDP datagrams that the sockets of this machine, or network namespace, dropped since its start.
struct UdpErrors {
  /// For whatever reason, and of these because a buffer was full.
  std::int64_t all = 0, buffer = 0;
};

/// nullopt where the system does not tell.
QUADRILLE_EXPORT std::optional<UdpErrors> read_udp_errors();

/// Datagrams that one socket dropped, by cause.
struct Drops {
  std::int64_t buffer = 0;    ///< its buffer was full
  std::int64_t filtered = 0;  ///< its filter refused them
  std::int64_t unclear = 0;   ///< one or the other
};

/// Tells why a socket dropped datagrams.
///
/// The kernel counts together what a socket's filter refuses and what its buffer has no room for;
/// for all sockets together it counts the two apart. Over a short time that bounds both: where no
/// socket lacked room the filter was the cause, and where no filter refused anything the buffer
/// was. What is left, when both happened at once and to several sockets, is unclear.
class DropCauses {
 public:
  /// @param errors   before the first update
  /// @param dropped  by the socket by then; the kernel counts in 32 bits
  DropCauses(std::optional<UdpErrors> errors, std::uint32_t dropped)
      : before_(errors), dropped_(dropped) {}

  /// @param before, after  read before and after what the socket dropped
  QUADRILLE_EXPORT void update(std::optional<UdpErrors> before, std::uint32_t dropped,
                               std::optional<UdpErrors> after);

  const Drops& drops() const { return drops_; }

 private:
  std::optional<UdpErrors> before_;
  std::uint32_t dropped_;
  Drops drops_;
};

}  // namespace quadrille::bus
