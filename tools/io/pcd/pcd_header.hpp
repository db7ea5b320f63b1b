#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// One field of a PCD point: `count` values of `size` bytes and type F, I or U.
struct PcdField {
  std::string name;
  std::uint64_t size = 4;
  char type = 'F';
  std::uint64_t count = 1;
};

/// The header of a PCD file, checked for contradictions.
struct PcdHeader {
  enum class Data { kAscii, kBinary, kCompressed };
  Data data = Data::kAscii;
  std::vector<PcdField> fields;
  std::uint64_t width = 0, height = 1, points = 0;
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
  /// Offset at which the data begins [bytes].
  std::size_t size = 0;
  /// Indices of x, y and z among the fields.
  std::array<std::size_t, 3> position{};
  /// Index of the colour among the fields (0x00RRGGBB in 4 bytes of any type), if there is one.
  std::optional<std::size_t> rgb;

  /// Bytes of one point in a binary file, and values of one point in an ascii file.
  std::uint64_t point_step() const;
  std::uint64_t values_per_point() const;
  /// Offset of a field within a point [bytes].
  std::uint64_t offset_of(std::size_t field) const;
};

/// Reads the header.
/// @throws FileError naming the field that is wrong
PcdHeader parse_pcd_header(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadrille::io
