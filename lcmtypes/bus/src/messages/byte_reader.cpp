#include "messages/byte_reader.hpp"

#include <algorithm>
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

std::uint64_t ByteReader::read_big_endian(std::size_t size, const char* member) {
  if (left() < size) refuse(RejectReason::kCutShort, std::string("ends within ") + member);
  std::uint64_t value = 0;
  for (const std::byte byte : bytes_.subspan(position_, size)) {
    value = value << 8 | std::to_integer<std::uint64_t>(byte);
  }
  position_ += size;
  return value;
}

double ByteReader::read_finite(const char* member) {
  const double value = read_double(member);
  if (!std::isfinite(value)) {
    refuse(RejectReason::kBadValue, std::string(member) + " is not finite");
  }
  return value;
}

double ByteReader::skip_finite(const char* member, int count) {
  double squared = 0.0;
  for (int i = 0; i < count; ++i) squared += std::pow(read_finite(member), 2);
  return squared;
}

void ByteReader::skip_unit(const char* member, int count) {
  if (!(std::abs(skip_finite(member, count) - 1.0) < 1e-6)) {
    refuse(RejectReason::kBadValue, std::string(member) + " is not of unit norm");
  }
}

void ByteReader::skip_pose() {
  skip_finite("position", 3);
  skip_unit("quaternion", 4);
}

std::int32_t ByteReader::read_count(const char* member, std::size_t min_element_bytes) {
  const std::int32_t count = read_int32(member);
  if (count < 0 || static_cast<std::uint64_t>(count) * min_element_bytes > left()) {
    refuse(RejectReason::kBadLength, std::string(member) + " = " + std::to_string(count) +
                                         " with " + std::to_string(left()) + " bytes left");
  }
  return count;
}

void ByteReader::skip_strings(const char* member) {
  skip_list(member, kMinStringBytes, [&](ByteReader& reader) { reader.skip_string(member); });
}

void ByteReader::skip_counts(const char* member) {
  skip_list(member, kMinStringBytes + 8, [](ByteReader& reader) {
    reader.skip_string("name");
    reader.read_int64("count");
  });
}

void ByteReader::skip_array(const char* member, std::size_t element_bytes) {
  take(read_count(member, element_bytes), static_cast<std::int64_t>(element_bytes), member);
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

void ByteReader::expect_end() const {
  if (left() != 0) {
    refuse(RejectReason::kTrailingBytes, std::to_string(left()) + " bytes after the last member");
  }
}

}  // namespace quadrille::bus
