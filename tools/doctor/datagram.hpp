#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace quadrille::doctor {

/// The header of one of LCM's datagrams.
struct Datagram {
  /// Number of the message in the sequence of its sender.
  std::uint32_t sequence = 0;
  /// Size of the whole message [byte].
  std::uint32_t message_bytes = 0;
  /// Index of the fragment, and number of fragments of the message.
  std::uint32_t fragment = 0, fragments = 1;
  /// Name of the channel; only the first fragment has it.
  std::string channel;
  /// The first bytes of the message, in the first fragment only.
  std::span<const std::byte> start;
};

/// Parses a datagram; nullopt if LCM would not accept it.
std::optional<Datagram> read_datagram(std::span<const std::byte> bytes);

/// Reads an eight-byte number in LCM's byte order from an offset of a message; nullopt if there are
/// fewer bytes.
std::optional<std::int64_t> read_number(std::span<const std::byte> bytes, std::size_t at);

}  // namespace quadrille::doctor
