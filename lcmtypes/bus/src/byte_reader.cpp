#include "byte_reader.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace quadrille::bus {

void refuse(RejectReason reason, std::string detail) { throw Refused{{reason, std::move(detail)}}; }

std::span<const std::byte> ByteReader::take(std::int64_t count, std::int64_t element_bytes,
                                            const char* member) {
  std::int64_t size = 0;
  if (count < 0 || element_bytes < 0 || __builtin_mul_overflow(count, element_bytes, &size)) {
    refuse(RejectReason::kBadLength, std::string(member) + ": length " + std::to_string(count));
  }
  if (static_cast<std::uint64_t>(size) > left()) {
    refuse(RejectReason::kBadLength, std::string(member) + ": " + std::to_string(size) +
                                         " bytes announced, " + std::to_string(left()) + " left");
  }
  const auto taken = bytes_.subspan(position_, static_cast<std::size_t>(size));
  position_ += taken.size();
  return taken;
}

template <class Integer>
Integer ByteReader::read_integer(const char* member) {
  if (left() < sizeof(Integer)) {
    refuse(RejectReason::kCutShort, std::string("ends within ") + member);
  }
  std::uint64_t value = 0;
  for (const std::byte byte : bytes_.subspan(position_, sizeof(Integer))) {
    value = value << 8 | std::to_integer<std::uint64_t>(byte);
  }
  position_ += sizeof(Integer);
  return static_cast<Integer>(value);
}

std::int8_t ByteReader::read_int8(const char* member) { return read_integer<std::int8_t>(member); }

std::int16_t ByteReader::read_int16(const char* member) {
  return read_integer<std::int16_t>(member);
}

std::int32_t ByteReader::read_int32(const char* member) {
  return read_integer<std::int32_t>(member);
}

std::int64_t ByteReader::read_int64(const char* member) {
  return read_integer<std::int64_t>(member);
}

double ByteReader::read_double(const char* member) {
  return std::bit_cast<double>(read_int64(member));
}

double ByteReader::read_finite(const char* member) {
  const double value = read_double(member);
  if (!std::isfinite(value)) {
    refuse(RejectReason::kBadValue, std::string(member) + " is not finite");
  }
  return value;
}

std::int32_t ByteReader::read_count(const char* member, std::size_t min_element_bytes) {
  const std::int32_t count = read_int32(member);
  if (count < 0 || static_cast<std::uint64_t>(count) * min_element_bytes > left()) {
    refuse(RejectReason::kBadLength, std::string(member) + " = " + std::to_string(count) +
                                         " with " + std::to_string(left()) + " bytes left");
  }
  return count;
}

std::span<const std::byte> ByteReader::take_string(const char* member) {
  const auto characters = take(read_int32(member), 1, member);
  if (characters.empty() || characters.back() != std::byte{0}) {
    refuse(RejectReason::kBadLength, std::string(member) + ": a string without its end mark");
  }
  const auto text = characters.first(characters.size() - 1);
  // Such a string could not be encoded again.
  if (std::find(text.begin(), text.end(), std::byte{0}) != text.end()) {
    refuse(RejectReason::kBadValue, std::string(member) + ": a string with a NUL in it");
  }
  return text;
}

std::string ByteReader::read_string(const char* member, std::size_t max_bytes) {
  const auto characters = take_string(member);
  if (characters.size() > max_bytes) {
    refuse(RejectReason::kBadLength,
           std::string(member) + ": a string of " + std::to_string(characters.size()) + " bytes");
  }
  return {reinterpret_cast<const char*>(characters.data()), characters.size()};
}

void ByteReader::skip_string(const char* member) { take_string(member); }

void ByteReader::expect_end() const {
  if (left() != 0) {
    refuse(RejectReason::kTrailingBytes, std::to_string(left()) + " bytes after the last member");
  }
}

}  // namespace quadrille::bus
