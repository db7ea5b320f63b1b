#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/word.hpp"

namespace quadrille {

/// Red, green and blue, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

/// One measured cloud in the frame C of its points.
struct PointCloud {
  /// Positions p_C [m]. A missing point of an organised cloud has NaN coordinates.
  std::vector<Eigen::Vector3f> points;
  /// The colour of each point, missing ones included; empty if the source has no colours or they
  /// were not requested.
  std::vector<Rgb> colours;
  /// Pixels per row if the cloud is organised (row by row); otherwise 0.
  int width = 0;
  /// Rows if the cloud is organised; otherwise 0.
  int height = 0;
  /// Position of the sensor in frame C [m].
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
  /// Name of frame C.
  std::string frame;
  /// Number of points that the source announced, before any was dropped.
  std::size_t read = 0;

  bool organised() const { return width > 0 && height > 1; }
  bool coloured() const { return !colours.empty() && colours.size() == points.size(); }
};

/// A view of one measured cloud in the frame C of its points, which are stored elsewhere. The
/// points must stay in place and unchanged while the view is used.
struct CloudView {
  CloudView() = default;
  /// Views the points of a cloud. The conversion is implicit so that functions on clouds accept
  /// both.
  CloudView(const PointCloud& cloud)  // NOLINT(google-explicit-constructor)
      : points(cloud.points),
        width(cloud.width),
        height(cloud.height),
        viewpoint(cloud.viewpoint) {}

  /// Positions p_C [m]. A missing point of an organised cloud has NaN coordinates; points farther
  /// than kMaxRange from the viewpoint count as missing (see check_range()).
  std::span<const Eigen::Vector3f> points;
  /// Pixels per row if the cloud is organised (row by row); otherwise 0.
  int width = 0;
  /// Rows if the cloud is organised; otherwise 0.
  int height = 0;
  /// Position of the sensor in frame C [m].
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();

  bool organised() const { return width > 0 && height > 1; }
};

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

constexpr auto words_of(PointLayout::Scalar) {
  return std::to_array<Word<PointLayout::Scalar>>(
      {{"float32", PointLayout::Scalar::kFloat32}, {"float64", PointLayout::Scalar::kFloat64}});
}

/// Reads the points from raw bytes; NaN, infinite and all-zero records count as missing.
///
/// Missing points are dropped from an unorganised cloud and kept as NaN in an organised one. Points
/// too far from the viewpoint, which is not known here, are left to check_range().
/// @param bytes   the records
/// @param layout  positions of the coordinates
/// @param X_CF    pose of the records' frame F in frame C, times the length of the records' unit in
///   metres; applied before the points are rounded to single precision
/// @return the cloud with its viewpoint at the origin of C and without a frame name
/// @throws std::invalid_argument if the layout does not fit into the bytes
QUADRILLE_EXPORT PointCloud read_points(std::span<const std::byte> bytes, const PointLayout& layout,
                                        const Eigen::Affine3d& X_CF = Eigen::Affine3d::Identity());

}  // namespace quadrille
