#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "quadrille/bus/rejection.hpp"

namespace quadrille::bus {

/// Thrown within the decoders and caught at their public entry.
struct Refused {
  Rejection rejection;
};

/// Size of the shortest string, which has only its length and its end mark [byte].
inline constexpr std::size_t kMinStringBytes = 5;

/// Reads the members of an LCM message in order and never past its end. Each read throws Refused,
/// naming the member, if the bytes do not contain it.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::int8_t read_int8(const char* member);
  std::int16_t read_int16(const char* member);
  std::int32_t read_int32(const char* member);
  std::int64_t read_int64(const char* member);
  double read_double(const char* member);

  /// Reads a double that must be finite.
  double read_finite(const char* member);

  /// Reads a 32-bit count, not negative, of elements of at least min_element_bytes each.
  std::int32_t read_count(const char* member, std::size_t min_element_bytes);

  /// Reads a string of at most max_bytes without its end mark.
  std::string read_string(const char* member, std::size_t max_bytes);

  /// Skips a string of any length.
  void skip_string(const char* member);

  /// Takes the next count * element_bytes bytes.
  std::span<const std::byte> take(std::int64_t count, std::int64_t element_bytes,
                                  const char* member);

  /// Number of bytes not yet read.
  std::size_t left() const { return bytes_.size() - position_; }

  /// Refuses bytes after the last member.
  void expect_end() const;

 private:
  template <class Integer>
  Integer read_integer(const char* member);
  std::span<const std::byte> take_string(const char* member);

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

/// Refuses the message.
/// @throws Refused always
[[noreturn]] void refuse(RejectReason reason, std::string detail);

}  // namespace quadrille::bus
