#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Layout of points in bytes: one record per point, with float32 or float64 x, y, z at any offset.
struct PointLayout {
  /// Width of one coordinate.
  enum class Scalar { kFloat32, kFloat64 };

  Scalar scalar = Scalar::kFloat32;
  bool big_endian = false;
  /// Byte offsets of x, y and z within a record.
  std::size_t x = 0, y = 4, z = 8;
  /// Bytes from one record to the next within a row.
  std::size_t point_step = 12;
  /// Bytes from one row to the next; 0 means width * point_step.
  std::size_t row_step = 0;
  /// Records per row, and number of rows; an unorganised cloud has height 1.
  std::size_t width = 0, height = 1;
  /// Byte offsets of red, green and blue within a record, one byte each; if absent, no colours are
  /// kept.
  std::optional<std::array<std::size_t, 3>> rgb;
};

/// Reads the points from raw bytes; NaN, infinite and all-zero records count as missing.
///
/// Missing points are dropped from an unorganised cloud and kept as NaN in an organised one. Points
/// too far from the viewpoint, which is not known here, are left to check_range().
/// @param bytes   the records
/// @param layout  positions of the coordinates
/// @param X_CF    pose of the records' frame F in frame C; applied before the points are rounded to
///   single precision
/// @return the cloud with its viewpoint at the origin of C and without a frame name
/// @throws std::invalid_argument if the layout does not fit into the bytes
QUADRILLE_EXPORT PointCloud
read_points(std::span<const std::byte> bytes, const PointLayout& layout,
            const Eigen::Isometry3d& X_CF = Eigen::Isometry3d::Identity());

}  // namespace quadrille
