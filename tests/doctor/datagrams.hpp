#pragma once

#include <cstddef>
#include <cstdint>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <span>
#include <string>
#include <vector>

namespace quadrille::doctor::test {

/// Times [us].
inline constexpr std::int64_t kNow = 1'800'000'000'000'000, kSecond = 1'000'000;

/// Bytes as LCM's protocol description has them.
class Bytes {
 public:
  Bytes& number(std::uint64_t value, int size) {
    for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) {
      bytes_.push_back(static_cast<std::byte>(value >> shift & 0xff));
    }
    return *this;
  }
  Bytes& name(const std::string& text) {
    for (const char c : text) bytes_.push_back(static_cast<std::byte>(c));
    return number(0, 1);
  }
  Bytes& bytes(std::span<const std::byte> more) {
    bytes_.insert(bytes_.end(), more.begin(), more.end());
    return *this;
  }
  operator std::span<const std::byte>() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

/// A whole message in one datagram.
inline Bytes whole_message(std::uint32_t sequence, const std::string& channel,
                           std::span<const std::byte> message) {
  Bytes bytes;
  bytes.number(0x4c433032, 4).number(sequence, 4).name(channel);
  return bytes.bytes(message);
}

/// A whole message in one datagram: its type, its time and nothing else.
inline Bytes short_message(std::uint32_t sequence, const std::string& channel,
                           std::int64_t fingerprint, std::int64_t utime) {
  Bytes message;
  message.number(static_cast<std::uint64_t>(fingerprint), 8);
  message.number(static_cast<std::uint64_t>(utime), 8);
  return whole_message(sequence, channel, message);
}

/// A part of a cloud on the channel POINT_CLOUD, of the time kNow.
inline Bytes fragment(std::uint32_t sequence, std::uint32_t size, std::uint32_t offset,
                      std::uint32_t number, std::uint32_t count) {
  Bytes bytes;
  bytes.number(0x4c433033, 4).number(sequence, 4).number(size, 4).number(offset, 4);
  bytes.number(number, 2).number(count, 2);
  if (number == 0) bytes.name("POINT_CLOUD");
  return bytes.number(static_cast<std::uint64_t>(drake::lcmt_point_cloud::getHash()), 8)
      .number(kNow, 8);
}

}  // namespace quadrille::doctor::test
