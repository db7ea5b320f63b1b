#include "io/npy/npy.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "io/file_bytes.hpp"
#include "io/npy/npy_header.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {
namespace {

constexpr const char* kRemedy =
    "save floats, in metres, of shape (N, 3), or (H, W, 3) of an organised cloud";

/// Sets type and byte order of the coordinates; returns false if they are not floats.
bool set_type(const NpyField& field, PointLayout* layout) {
  layout->scalar = field.size == 8 ? PointLayout::Scalar::kFloat64 : PointLayout::Scalar::kFloat32;
  layout->big_endian = field.type.starts_with('>');
  return field.type.size() == 3 && (field.type.ends_with("f4") || field.type.ends_with("f8"));
}

/// Sets rows and columns from the dimensions of the array, without that of x, y, z.
void set_size(std::span<const std::uint64_t> shape, const std::string& name, PointLayout* layout) {
  const std::uint64_t most = std::numeric_limits<int>::max();
  if (std::any_of(shape.begin(), shape.end(), [&](auto count) { return count > most; })) {
    throw FileError(name, "shape", "has more points than can be worked on; thin the cloud out");
  }
  layout->width = shape.back();
  layout->height = shape.size() == 2 ? shape.front() : 1;
}

PointLayout layout_of_array(const NpyHeader& header, const std::string& name) {
  PointLayout layout;
  if (!set_type(header.fields.front(), &layout)) {
    throw FileError(
        name, "type",
        fmt::format("'{}' is no float of 4 or 8 bytes; {}", header.fields.front().type, kRemedy));
  }
  const std::size_t dimensions = header.shape.size();
  if (dimensions < 2 || dimensions > 3 || header.shape.back() != 3) {
    throw FileError(name, "shape",
                    fmt::format("({}) is no cloud; {}", fmt::join(header.shape, ", "), kRemedy));
  }
  layout.y = header.record_size;
  layout.z = 2 * header.record_size;
  layout.point_step = 3 * header.record_size;
  set_size(std::span(header.shape).first(dimensions - 1), name, &layout);
  return layout;
}

PointLayout layout_of_records(const NpyHeader& header, const std::string& name) {
  PointLayout layout;
  std::string type;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string wanted(1, "xyz"[axis]);
    const auto field = std::find_if(header.fields.begin(), header.fields.end(),
                                    [&](const NpyField& f) { return f.name == wanted; });
    if (field == header.fields.end() || !set_type(*field, &layout) ||
        (axis > 0 && field->type != type)) {
      throw FileError(name, fmt::format("field {}", wanted),
                      "records need x, y and z as floats of one type; or save an (N, 3) array");
    }
    type = field->type;
    (axis == 0 ? layout.x : axis == 1 ? layout.y : layout.z) = field->offset;
  }
  if (header.shape.empty() || header.shape.size() > 2) {
    throw FileError(name, "shape", "records need the shape (N,), or (H, W) of an organised cloud");
  }
  layout.point_step = header.record_size;
  set_size(header.shape, name, &layout);
  return layout;
}

/// Converts an array that is stored column by column to C order.
std::vector<std::byte> in_c_order(std::span<const std::byte> data, const NpyHeader& header) {
  const std::size_t size = header.record_size;
  std::size_t count = 1;
  for (const std::uint64_t n : header.shape) count *= n;
  std::vector<std::byte> ordered(count * size);
  std::vector<std::uint64_t> index(header.shape.size(), 0);
  for (std::size_t n = 0; n < count; ++n) {
    std::size_t from = 0;
    for (std::size_t axis = index.size(); axis-- > 0;)
      from = from * header.shape[axis] + index[axis];
    std::memcpy(&ordered[n * size], &data[from * size], size);
    for (std::size_t axis = index.size(); axis-- > 0;) {
      if (++index[axis] < header.shape[axis]) break;
      index[axis] = 0;
    }
  }
  return ordered;
}

double number_at(const std::byte* from, const PointLayout& layout) {
  std::array<std::byte, 8> raw;
  const std::size_t size = layout.scalar == PointLayout::Scalar::kFloat64 ? 8 : 4;
  std::memcpy(raw.data(), from, size);
  if (layout.big_endian != (std::endian::native == std::endian::big)) {
    std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
  }
  if (size == 8) return std::bit_cast<double>(raw);
  float number;
  std::memcpy(&number, raw.data(), size);
  return static_cast<double>(number);
}

}  // namespace

PointCloud parse_npy(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF) {
  const NpyHeader header = parse_npy_header(bytes, name);
  const PointLayout layout =
      header.is_plain() ? layout_of_array(header, name) : layout_of_records(header, name);
  const std::span<const std::byte> data = bytes.subspan(header.data_offset);
  PointCloud cloud = header.fortran_order ? read_points(in_c_order(data, header), layout, X_CF)
                                          : read_points(data, layout, X_CF);
  cloud.viewpoint = X_CF.translation();
  return cloud;
}

Eigen::Vector3d parse_npy_vector(std::span<const std::byte> bytes, const std::string& name) {
  const NpyHeader header = parse_npy_header(bytes, name);
  PointLayout layout;
  if (!header.is_plain() || !set_type(header.fields.front(), &layout) ||
      header.shape != std::vector<std::uint64_t>{3}) {
    throw FileError(name, "shape", "is no (3,) of floats of 4 or 8 bytes; save it as such");
  }
  const std::byte* const first = &bytes[header.data_offset];
  Eigen::Vector3d vector;
  for (int axis = 0; axis < 3; ++axis) {
    vector[axis] = number_at(first + static_cast<std::size_t>(axis) * header.record_size, layout);
  }
  if (!vector.allFinite()) throw FileError(name, "", "is not finite; save three numbers [m]");
  return vector;
}

}  // namespace quadrille::io
