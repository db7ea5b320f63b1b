#pragma once

#include <cstdint>
#include <optional>

namespace quadrille::bus {

/// Counts of UDP datagrams that the sockets of this machine, or of its network namespace, dropped
/// since its start.
struct UdpErrors {
  /// Datagrams dropped for any reason, and those among them for which a buffer had no room.
  std::int64_t all = 0, buffer = 0;
};

/// Returns nullopt if the system does not tell.
std::optional<UdpErrors> read_udp_errors();

/// Counts of datagrams that one socket dropped, by cause.
struct Drops {
  std::int64_t buffer = 0;    ///< its buffer was full
  std::int64_t filtered = 0;  ///< its filter refused them
  std::int64_t unclear = 0;   ///< one of the two
};

/// Finds out why a socket dropped datagrams.
///
/// For one socket the kernel counts filtered datagrams and lack of buffer space together; only for
/// all sockets in total it counts them apart. Over a short time this bounds both: if no socket
/// lacked room, the filter was the cause, and if no filter refused anything, the buffer was. The
/// rest, when both happened at once and on several sockets, is unclear.
class DropCauses {
 public:
  /// @param errors   counts before the first update
  /// @param dropped  datagrams that the socket had dropped by then; the kernel counts in 32 bits
  DropCauses(std::optional<UdpErrors> errors, std::uint32_t dropped)
      : before_(errors), dropped_(dropped) {}

  /// @param before, after  counts read before and after `dropped` was read
  void update(std::optional<UdpErrors> before, std::uint32_t dropped,
              std::optional<UdpErrors> after);

  const Drops& drops() const { return drops_; }

 private:
  std::optional<UdpErrors> before_;
  std::uint32_t dropped_;
  Drops drops_;
};

}  // namespace quadrille::bus
