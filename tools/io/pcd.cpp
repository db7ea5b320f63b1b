#include "io/pcd.hpp"

#include <liblzf/lzf.h>

#include <bit>
#include <cstring>

#include "io/file_bytes.hpp"
#include "io/header_lines.hpp"
#include "io/pcd_header.hpp"
#include "quadrille/detector/ingest.hpp"

namespace quadrille::io {
namespace {

/// LZF turns 3 bytes into 264 at best.
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

PointLayout packed_layout(const PcdHeader& header) {
  PointLayout layout;
  const bool organised = header.height > 1 && header.width > 1;
  layout.width = organised ? header.width : header.points;
  layout.height = organised ? header.height : 1;
  return layout;
}

PointCloud read_packed(const PcdHeader& header, const std::vector<float>& packed,
                       const Eigen::Isometry3d& X_CF) {
  return read_points(std::as_bytes(std::span(packed)), packed_layout(header), X_CF);
}

PointCloud read_ascii(std::span<const std::byte> bytes, const PcdHeader& header,
                      const std::string& name, const Eigen::Isometry3d& X_CF) {
  const std::uint64_t values = header.values_per_point();
  if (header.points > (bytes.size() - header.size + 1) / (2 * values)) {
    fail_short(name, bytes.size(), header);
  }
  std::array<std::uint64_t, 3> columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < header.position[axis]; ++i) columns[axis] += header.fields[i].count;
  }
  TextCursor cursor(bytes, header.size);
  std::vector<float> packed(3 * header.points);
  for (std::uint64_t point = 0; point < header.points; ++point) {
    for (std::uint64_t column = 0; column < values; ++column) {
      const std::string_view word = cursor.next_word();
      if (word.empty()) fail_short(name, bytes.size(), header);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (columns[axis] != column) continue;
        const auto value = to_number(word);
        if (!value) {
          throw FileError(name, "byte " + std::to_string(cursor.offset() - word.size()),
                          "'" + std::string(word.substr(0, 40)) + "' is no number; correct it");
        }
        packed[3 * point + axis] = static_cast<float>(*value);
      }
    }
  }
  return read_packed(header, packed, X_CF);
}

PointCloud read_binary(std::span<const std::byte> bytes, const PcdHeader& header,
                       const std::string& name, const Eigen::Isometry3d& X_CF) {
  const std::span<const std::byte> data = bytes.subspan(header.size);
  const std::uint64_t step = header.point_step();
  if (header.points > data.size() / step) fail_short(name, bytes.size(), header);
  const auto& [x, y, z] = header.position;
  const std::uint64_t size = header.fields[x].size;
  if (header.fields[y].size == size && header.fields[z].size == size) {
    PointLayout layout = packed_layout(header);
    if (size == 8) layout.scalar = PointLayout::Scalar::kFloat64;
    layout.x = header.offset_of(x);
    layout.y = header.offset_of(y);
    layout.z = header.offset_of(z);
    layout.point_step = step;
    return read_points(data, layout, X_CF);
  }
  std::vector<float> packed(3 * header.points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t field = header.position[axis];
    const std::byte* from = data.data() + header.offset_of(field);
    for (std::uint64_t i = 0; i < header.points; ++i) {
      packed[3 * i + axis] = load(from + i * step, header.fields[field]);
    }
  }
  return read_packed(header, packed, X_CF);
}

/// The decompressed data of a binary_compressed file: all x, then all y, …
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
                           const std::string& name, const Eigen::Isometry3d& X_CF) {
  const std::vector<std::byte> data = decompress(bytes, header, name);
  std::vector<float> packed(3 * header.points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t field = header.position[axis];
    const PcdField& f = header.fields[field];
    const std::byte* from = data.data() + header.offset_of(field) * header.points;
    for (std::uint64_t i = 0; i < header.points; ++i) {
      packed[3 * i + axis] = load(from + i * f.size, f);
    }
  }
  return read_packed(header, packed, X_CF);
}

PointCloud read_data(std::span<const std::byte> bytes, const PcdHeader& header,
                     const std::string& name, const Eigen::Isometry3d& X_CF) {
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
                     const Eigen::Isometry3d& X_CF) {
  const PcdHeader header = parse_pcd_header(bytes, name);
  PointCloud cloud = read_data(bytes, header, name, X_CF);
  cloud.viewpoint = X_CF * header.viewpoint;
  return cloud;
}

PointCloud read_pcd(const std::string& path, const Eigen::Isometry3d& X_CF) {
  return parse_pcd(read_file(path), path, X_CF);
}

}  // namespace quadrille::io
