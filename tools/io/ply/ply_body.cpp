#include "io/ply/ply_body.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "io/file_bytes.hpp"
#include "io/header_lines.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

template <class Scalar>
double load(const std::byte* from, bool swap) {
  std::array<std::byte, sizeof(Scalar)> raw;
  std::memcpy(raw.data(), from, raw.size());
  if (swap) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<Scalar>(raw));
}

double load(const std::byte* from, PlyScalar scalar, bool swap) {
  switch (scalar) {
    case PlyScalar::kInt8:
      return load<std::int8_t>(from, swap);
    case PlyScalar::kUint8:
      return load<std::uint8_t>(from, swap);
    case PlyScalar::kInt16:
      return load<std::int16_t>(from, swap);
    case PlyScalar::kUint16:
      return load<std::uint16_t>(from, swap);
    case PlyScalar::kInt32:
      return load<std::int32_t>(from, swap);
    case PlyScalar::kUint32:
      return load<std::uint32_t>(from, swap);
    case PlyScalar::kFloat32:
      return load<float>(from, swap);
    case PlyScalar::kFloat64:
      break;
  }
  return load<double>(from, swap);
}

}  // namespace

PlyBody::PlyBody(std::span<const std::byte> bytes, const PlyHeader& header, const std::string& name)
    : bytes_(bytes), header_(header), name_(name), offset_(header.size) {}

void PlyBody::fail_short(const PlyElement& element) const {
  throw FileError(name_, "byte " + std::to_string(bytes_.size()),
                  "the file ends before its " + std::to_string(element.count) + " '" +
                      printable(element.name) + "' records do; copy it again or correct the count");
}

void PlyBody::check_count(const PlyElement& element) const {
  const bool ascii = header_.format == PlyHeader::Format::kAscii;
  const std::uint64_t least = element.min_bytes(ascii);
  // The last value of an ascii file needs no separator after it.
  const std::uint64_t left = bytes_.size() - offset_ + (ascii ? 1 : 0);
  if (least > 0 && element.count > left / least) fail_short(element);
}

/// Calls visit(record, property index, value) for each scalar that is not part of a list.
template <class Visitor>
void PlyBody::walk_binary(const PlyElement& element, Visitor&& visit) {
  const bool swap = (header_.format == PlyHeader::Format::kBigEndian) !=
                    (std::endian::native == std::endian::big);
  const auto need = [&](std::size_t n) {
    if (bytes_.size() - offset_ < n) fail_short(element);
  };
  for (std::uint64_t record = 0; record < element.count; ++record) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const PlyScalar scalar = property.is_list ? property.count : property.scalar;
      need(size_of(scalar));
      const double value = load(bytes_.data() + offset_, scalar, swap);
      offset_ += size_of(scalar);
      if (property.is_list) {
        if (value < 0) {
          throw FileError(
              name_, "byte " + std::to_string(offset_),
              "list '" + printable(property.name) + "' has a negative length; copy it again");
        }
        // There are at most 2^32 values of 8 bytes, so this cannot overflow.
        const std::size_t length = static_cast<std::size_t>(value) * size_of(property.scalar);
        need(length);
        offset_ += length;
      } else {
        visit(record, i, value);
      }
    }
  }
}

template <class Visitor>
void PlyBody::walk_ascii(const PlyElement& element, Visitor&& visit) {
  TextCursor cursor(bytes_, offset_);
  const auto next = [&]() -> double {
    const std::string_view word = cursor.next_word();
    if (word.empty()) fail_short(element);
    const auto value = to_number(word);
    if (!value) {
      throw FileError(name_, "byte " + std::to_string(cursor.offset() - word.size()),
                      "'" + printable(word) + "' is no number; correct it");
    }
    return *value;
  };
  for (std::uint64_t record = 0; record < element.count; ++record) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const double value = next();
      if (element.properties[i].is_list) {
        for (double k = 0; k < value; ++k) next();
      } else {
        visit(record, i, value);
      }
    }
  }
  offset_ = cursor.offset();
}

template <class Visitor>
void PlyBody::walk(const PlyElement& element, Visitor&& visit) {
  check_count(element);
  // Records without properties take no bytes, whatever their number.
  if (element.properties.empty()) return;
  if (header_.format == PlyHeader::Format::kAscii) {
    walk_ascii(element, visit);
  } else {
    walk_binary(element, visit);
  }
}

void PlyBody::skip(const PlyElement& element) {
  const bool ascii = header_.format == PlyHeader::Format::kAscii;
  if (!ascii && !element.has_list()) {
    check_count(element);
    offset_ += element.count * element.min_bytes(false);
  } else {
    walk(element, [](std::uint64_t, std::size_t, double) {});
  }
}

std::vector<PackedPoint> PlyBody::read_points(
    const PlyElement& element, const std::array<std::size_t, 3>& columns,
    const std::optional<std::array<std::size_t, 3>>& colours) {
  check_count(element);
  std::vector<PackedPoint> packed(element.count);
  walk(element, [&](std::uint64_t record, std::size_t property, double value) {
    PackedPoint& point = packed[record];
    for (std::size_t i = 0; i < 3; ++i) {
      if (columns[i] == property) point.position[i] = static_cast<float>(value);
      // In text, a byte may be given as any number.
      if (colours && (*colours)[i] == property && value >= 0.0 && value <= 255.0) {
        point.rgb[i] = static_cast<std::uint8_t>(value);
      }
    }
  });
  return packed;
}

}  // namespace quadrille::io
