#include "doctor/datagram.hpp"

#include <algorithm>

namespace quadrille::doctor {
namespace {

constexpr std::uint32_t kShortMagic = 0x4c433032, kLongMagic = 0x4c433033;
constexpr std::size_t kShortHeader = 8, kLongHeader = 20, kMaxChannel = 63;

std::uint64_t big_endian(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (const std::byte byte : bytes) value = value << 8 | std::to_integer<std::uint64_t>(byte);
  return value;
}

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at, std::size_t size = 4) {
  return static_cast<std::uint32_t>(big_endian(bytes.subspan(at, size)));
}

/// Takes the name of the channel from the front; returns false if it has no end.
bool take_channel(std::span<const std::byte> rest, Datagram* datagram) {
  const auto end = std::find(rest.begin(), rest.end(), std::byte{0});
  const auto size = static_cast<std::size_t>(end - rest.begin());
  if (end == rest.end() || size > kMaxChannel) return false;
  datagram->channel.assign(reinterpret_cast<const char*>(rest.data()), size);
  datagram->start = rest.subspan(size + 1);
  return true;
}

std::optional<Datagram> read_fragment(std::span<const std::byte> bytes) {
  if (bytes.size() < kLongHeader) return std::nullopt;
  Datagram datagram;
  datagram.sequence = word(bytes, 4);
  datagram.message_bytes = word(bytes, 8);
  datagram.fragment = word(bytes, 16, 2);
  datagram.fragments = word(bytes, 18, 2);
  if (word(bytes, 12) > datagram.message_bytes) return std::nullopt;
  const bool is_first = datagram.fragment == 0;
  if (is_first && !take_channel(bytes.subspan(kLongHeader), &datagram)) return std::nullopt;
  return datagram;
}

}  // namespace

std::optional<Datagram> read_datagram(std::span<const std::byte> bytes) {
  if (bytes.size() < kShortHeader) return std::nullopt;
  if (word(bytes, 0) == kLongMagic) return read_fragment(bytes);
  if (word(bytes, 0) != kShortMagic) return std::nullopt;
  Datagram datagram;
  datagram.sequence = word(bytes, 4);
  if (!take_channel(bytes.subspan(kShortHeader), &datagram)) return std::nullopt;
  datagram.message_bytes = static_cast<std::uint32_t>(datagram.start.size());
  return datagram;
}

std::optional<std::int64_t> read_number(std::span<const std::byte> bytes, std::size_t at) {
  if (bytes.size() < at + 8) return std::nullopt;
  return static_cast<std::int64_t>(big_endian(bytes.subspan(at, 8)));
}

}  // namespace quadrille::doctor
