#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Scalar types of PLY.
enum class PlyScalar { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// Number of bytes of one scalar.
std::size_t size_of(PlyScalar scalar);

/// One property of an element: a scalar, or a list with a count before its values.
struct PlyProperty {
  std::string name;
  PlyScalar scalar = PlyScalar::kFloat32;
  bool is_list = false;
  PlyScalar count = PlyScalar::kUint8;
};

/// A kind of record, and the number of its records.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const;
  /// Least number of bytes that one record takes in a file with this encoding.
  std::uint64_t min_bytes(bool ascii) const;
};

/// The header of a PLY file.
struct PlyHeader {
  enum class Format { kAscii, kLittleEndian, kBigEndian };
  Format format = Format::kAscii;
  std::vector<PlyElement> elements;
  /// Offset at which the data begins [bytes].
  std::size_t size = 0;
  /// Width and height that comments announce; 0 if none does.
  std::uint64_t width = 0, height = 0;
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
  std::string frame;
};

/// Reads the header.
/// @throws FileError naming the line that is wrong
PlyHeader parse_ply_header(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadrille::io
