#include "io/pcd/pcd.hpp"

#include <liblzf/lzf.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "io/file_bytes.hpp"
#include "io/header_lines.hpp"
#include "io/packed_point.hpp"
#include "io/pcd/pcd_header.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

/// LZF expands 3 bytes to at most 264.
constexpr std::uint64_t kMaxExpansion = 88;

[[noreturn]] void fail_short(const std::string& name, std::size_t size, const PcdHeader& header) {
  throw FileError(name, "byte " + std::to_string(size),
                  "the file ends before its " + std::to_string(header.points) +
                      " points do; copy it again or correct WIDTH, HEIGHT and POINTS");
}

/// Reads x, y or z of a record in memory as float.
float load(const std::byte* from, const PcdField& field) {
  static_assert(std::endian::native == std::endian::little, "PCD stores the writer's byte order");
  if (field.size == 8) {
    double wide;
    std::memcpy(&wide, from, sizeof wide);
    return static_cast<float>(wide);
  }
  float value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

Rgb rgb_of(std::uint32_t packed) {
  return {static_cast<std::uint8_t>(packed >> 16), static_cast<std::uint8_t>(packed >> 8),
          static_cast<std::uint8_t>(packed)};
}

Rgb load_rgb(const std::byte* from) {
  std::uint32_t packed;
  std::memcpy(&packed, from, sizeof packed);
  return rgb_of(packed);
}

/// Returns the colour that a word of an ascii file stands for. Writers use either 0xRRGGBB as a
/// number, or the float with those bits, which is tiny, or with an opaque alpha negative and huge.
Rgb rgb_of(std::string_view word) {
  const double value = to_number(word).value_or(0.0);
  if (value >= 1.0 && value <= 4294967295.0) return rgb_of(static_cast<std::uint32_t>(value));
  return rgb_of(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

void set_size(const PcdHeader& header, PointLayout* layout) {
  const bool organised = header.height > 1 && header.width > 1;
  layout->width = organised ? header.width : header.points;
  layout->height = organised ? header.height : 1;
}

PointCloud read_packed(const PcdHeader& header, const std::vector<PackedPoint>& packed,
                       const Eigen::Affine3d& X_CF) {
  PointLayout layout = packed_points_layout(header.rgb.has_value());
  set_size(header, &layout);
  return read_points(std::as_bytes(std::span(packed)), layout, X_CF);
}

/// Position of a field's values in binary data.
struct FieldPlace {
  const std::byte* first;
  std::size_t step;
};

/// Gathers the points from binary data; place_of(field) tells where the values of a field are.
template <class PlaceOf>
std::vector<PackedPoint> pack(const PcdHeader& header, PlaceOf&& place_of) {
  std::vector<PackedPoint> packed(header.points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t field = header.position[axis];
    const FieldPlace place = place_of(field);
    for (std::uint64_t i = 0; i < header.points; ++i) {
      packed[i].position[axis] = load(place.first + i * place.step, header.fields[field]);
    }
  }
  if (!header.rgb) return packed;
  const FieldPlace place = place_of(*header.rgb);
  for (std::uint64_t i = 0; i < header.points; ++i) {
    packed[i].rgb = load_rgb(place.first + i * place.step);
  }
  return packed;
}

/// Returns the column of a field in the lines of an ascii file.
std::uint64_t column_of(const PcdHeader& header, std::size_t field) {
  std::uint64_t column = 0;
  for (std::size_t i = 0; i < field; ++i) column += header.fields[i].count;
  return column;
}

PointCloud read_ascii(std::span<const std::byte> bytes, const PcdHeader& header,
                      const std::string& name, const Eigen::Affine3d& X_CF) {
  const std::uint64_t values = header.values_per_point();
  if (header.points > (bytes.size() - header.size + 1) / (2 * values)) {
    fail_short(name, bytes.size(), header);
  }
  std::array<std::uint64_t, 3> columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns[axis] = column_of(header, header.position[axis]);
  }
  const std::uint64_t rgb_column = header.rgb ? column_of(header, *header.rgb) : values;
  TextCursor cursor(bytes, header.size);
  std::vector<PackedPoint> packed(header.points);
  for (std::uint64_t point = 0; point < header.points; ++point) {
    for (std::uint64_t column = 0; column < values; ++column) {
      const std::string_view word = cursor.next_word();
      if (word.empty()) fail_short(name, bytes.size(), header);
      if (column == rgb_column) packed[point].rgb = rgb_of(word);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (columns[axis] != column) continue;
        const auto value = to_number(word);
        if (!value) {
          throw FileError(name, "byte " + std::to_string(cursor.offset() - word.size()),
                          "'" + printable(word) + "' is no number; correct it");
        }
        packed[point].position[axis] = static_cast<float>(*value);
      }
    }
  }
  return read_packed(header, packed, X_CF);
}

PointCloud read_binary(std::span<const std::byte> bytes, const PcdHeader& header,
                       const std::string& name, const Eigen::Affine3d& X_CF) {
  const std::span<const std::byte> data = bytes.subspan(header.size);
  const std::uint64_t step = header.point_step();
  if (header.points > data.size() / step) fail_short(name, bytes.size(), header);
  const auto& [x, y, z] = header.position;
  const std::uint64_t size = header.fields[x].size;
  if (header.fields[y].size == size && header.fields[z].size == size) {
    PointLayout layout;
    set_size(header, &layout);
    if (size == 8) layout.scalar = PointLayout::Scalar::kFloat64;
    layout.x = header.offset_of(x);
    layout.y = header.offset_of(y);
    layout.z = header.offset_of(z);
    layout.point_step = step;
    if (header.rgb) {
      const std::size_t rgb = header.offset_of(*header.rgb);
      layout.rgb = {rgb + 2, rgb + 1, rgb};
    }
    return read_points(data, layout, X_CF);
  }
  const auto place_of = [&](std::size_t field) {
    return FieldPlace{data.data() + header.offset_of(field), step};
  };
  return read_packed(header, pack(header, place_of), X_CF);
}

/// Returns the decompressed data of a binary_compressed file: all x, then all y, …
std::vector<std::byte> decompress(std::span<const std::byte> bytes, const PcdHeader& header,
                                  const std::string& name) {
  const std::span<const std::byte> data = bytes.subspan(header.size);
  std::array<std::uint32_t, 2> sizes{};
  if (data.size() < sizeof sizes) fail_short(name, bytes.size(), header);
  std::memcpy(sizes.data(), data.data(), sizeof sizes);
  const auto [compressed, uncompressed] = sizes;
  const std::uint64_t step = header.point_step();
  if (compressed > data.size() - sizeof sizes) fail_short(name, bytes.size(), header);
  const std::string where = "byte " + std::to_string(header.size);
  if (header.points > uncompressed / step || header.points * step != uncompressed) {
    throw FileError(name, where,
                    std::to_string(uncompressed) + " uncompressed bytes are not " +
                        std::to_string(header.points) + " points of " + std::to_string(step) +
                        " bytes; write the file again");
  }
  if (uncompressed > compressed * kMaxExpansion) {
    throw FileError(name, where,
                    "announces more data than its compressed bytes can hold; "
                    "write the file again");
  }
  std::vector<std::byte> out(uncompressed);
  if (uncompressed > 0 && lzf_decompress(data.data() + sizeof sizes, compressed, out.data(),
                                         uncompressed) != uncompressed) {
    throw FileError(name, where, "the compressed data is damaged; copy the file again");
  }
  return out;
}

PointCloud read_compressed(std::span<const std::byte> bytes, const PcdHeader& header,
                           const std::string& name, const Eigen::Affine3d& X_CF) {
  const std::vector<std::byte> data = decompress(bytes, header, name);
  const auto place_of = [&](std::size_t field) {
    return FieldPlace{data.data() + header.offset_of(field) * header.points,
                      header.fields[field].size};
  };
  return read_packed(header, pack(header, place_of), X_CF);
}

PointCloud read_data(std::span<const std::byte> bytes, const PcdHeader& header,
                     const std::string& name, const Eigen::Affine3d& X_CF) {
  switch (header.data) {
    case PcdHeader::Data::kAscii:
      return read_ascii(bytes, header, name, X_CF);
    case PcdHeader::Data::kBinary:
      return read_binary(bytes, header, name, X_CF);
    case PcdHeader::Data::kCompressed:
      break;
  }
  return read_compressed(bytes, header, name, X_CF);
}

}  // namespace

PointCloud parse_pcd(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF) {
  const PcdHeader header = parse_pcd_header(bytes, name);
  PointCloud cloud = read_data(bytes, header, name, X_CF);
  cloud.viewpoint = X_CF * header.viewpoint;
  return cloud;
}

}  // namespace quadrille::io
