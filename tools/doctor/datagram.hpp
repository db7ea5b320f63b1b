#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace quadrille::doctor {

/// What the head of one of LCM's datagrams says.
struct Datagram {
  /// Counts the messages of a sender.
  std::uint32_t sequence = 0;
  /// Of the whole message [byte].
  std::uint32_t message_bytes = 0;
  /// Of the datagrams of one message.
  std::uint32_t fragment = 0, fragments = 1;
  /// Only the first fragment tells it.
  std::string channel;
  /// The first bytes of the message; only of the first fragment.
  std::span<const std::byte> start;
};

/// Reads a datagram; nullopt if it is none that LCM would take.
std::optional<Datagram> read_datagram(std::span<const std::byte> bytes);

/// Eight bytes of a message from there on, as LCM writes numbers; nullopt if there are fewer.
std::optional<std::int64_t> read_number(std::span<const std::byte> bytes, std::size_t at);

}  // namespace quadrille::doctor
