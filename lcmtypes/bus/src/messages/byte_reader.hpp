#pragma once

#include <bit>
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
/// Size of a quadrille.pose_t [byte].
inline constexpr std::size_t kPoseBytes = 7 * sizeof(double);

/// Reads the members of an LCM message in order and never past its end. Each read throws Refused,
/// naming the member, if the bytes do not contain it.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::int8_t read_int8(const char* member) { return read_integer<std::int8_t>(member); }
  std::int16_t read_int16(const char* member) { return read_integer<std::int16_t>(member); }
  std::int32_t read_int32(const char* member) { return read_integer<std::int32_t>(member); }
  std::int64_t read_int64(const char* member) { return read_integer<std::int64_t>(member); }
  double read_double(const char* member) { return std::bit_cast<double>(read_int64(member)); }

  /// Reads a double that must be finite.
  double read_finite(const char* member);

  /// Skips doubles that must be finite, and returns the sum of their squares.
  double skip_finite(const char* member, int count);

  /// Skips doubles that must be finite and have unit norm.
  void skip_unit(const char* member, int count);

  /// Skips a quadrille.pose_t, which must be finite, with a quaternion of unit norm.
  void skip_pose();

  /// Reads a 32-bit count, not negative, of elements of at least min_element_bytes each.
  std::int32_t read_count(const char* member, std::size_t min_element_bytes);

  /// Reads such a count and calls `skip_element` for each element.
  template <class Skip>
  void skip_list(const char* member, std::size_t min_element_bytes, const Skip& skip_element) {
    for (std::int32_t k = read_count(member, min_element_bytes); k > 0; --k) skip_element(*this);
  }

  /// Skips such a count and strings of any length.
  void skip_strings(const char* member);

  /// Skips such a count and entries of a name and a 64-bit number, as in quadrille.count_t.
  void skip_counts(const char* member);

  /// Skips such a count and elements of element_bytes each.
  void skip_array(const char* member, std::size_t element_bytes);

  /// Reads a string of at most max_bytes without its end mark.
  std::string read_string(const char* member, std::size_t max_bytes);

  /// Skips a string of any length.
  void skip_string(const char* member) { take_string(member); }

  /// Takes the next count * element_bytes bytes.
  std::span<const std::byte> take(std::int64_t count, std::int64_t element_bytes,
                                  const char* member);

  /// Number of bytes not yet read.
  std::size_t left() const { return bytes_.size() - position_; }

  /// Refuses bytes after the last member.
  void expect_end() const;

 private:
  template <class Integer>
  Integer read_integer(const char* member) {
    return static_cast<Integer>(read_big_endian(sizeof(Integer), member));
  }
  std::uint64_t read_big_endian(std::size_t size, const char* member);
  std::span<const std::byte> take_string(const char* member);

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

/// Refuses the message.
/// @throws Refused always
[[noreturn]] void refuse(RejectReason reason, std::string detail);

}  // namespace quadrille::bus
