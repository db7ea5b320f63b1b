#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// Points sorted into cubes, to find those near a place.
class PointBuckets {
 public:
  /// A cube as one number. Numbers are in the order of the cubes' places: along x first, then along
  /// y, then along z.
  using Key = std::uint64_t;

  PointBuckets() = default;
  /// @param points_C  positions in frame C [m]
  /// @param edge  edge of a cube [m]
  PointBuckets(std::span<const Eigen::Vector3d> points_C, double edge);

  /// Returns the cube of edge `edge` [m] that holds a point. Beyond a million cubes from the origin
  /// there are no further ones: the outermost hold all points out there.
  static Key key_of(const Eigen::Vector3d& p_C, double edge) {
    // Truncation rounds down, since all values are positive by then.
    const Eigen::Array3d cube = (p_C / edge).array() + kShift;
    const Eigen::Array3d from_end = cube.max(-kFarthest).min(kFarthest) + kOrigin;
    return static_cast<Key>(static_cast<int>(from_end.x())) * kAlongX +
           static_cast<Key>(static_cast<int>(from_end.y())) * kAlongY +
           static_cast<Key>(static_cast<int>(from_end.z()));
  }

  /// The cubes that hold points, in ascending order.
  const std::vector<Key>& keys() const { return keys_; }
  /// The indices of the points in the n-th of these cubes, in ascending order.
  std::span<const int> members(std::size_t n) const { return between(n, n + 1); }

  /// The points in a cube and its 26 neighbours: all points that are nearer than an edge to any
  /// place in the cube, and some farther ones. They lie in nine rows of three cubes along z.
  using Near = std::array<std::span<const int>, 9>;
  /// Returns what lies near each of the cubes. The spans refer to these buckets.
  std::vector<Near> near_each() const;

 private:
  // Cubes are shifted by this share of their edge. Many sensors measure whole millimetres: without
  // the shift such points lie on the borders of cubes, where rounding decides to which one they
  // belong.
  static constexpr double kShift = 0.37;
  // A key has so many bits for each axis. The places of cubes are limited so that they fit, and
  // that their neighbours do.
  static constexpr int kBits = 21;
  // The origin lies in the middle of this power of two of cubes, whose keys have the leading bits
  // of each axis in common, which saves time when they are sorted.
  static constexpr int kNearBits = 11;
  static constexpr double kFarthest = (1 << (kBits - 1)) - (1 << (kNearBits - 1)) - 2;
  static constexpr double kOrigin = (1 << (kBits - 1)) + (1 << (kNearBits - 1));
  static constexpr Key kAlongX = Key{1} << (2 * kBits), kAlongY = Key{1} << kBits;

  std::span<const int> between(std::size_t n, std::size_t end) const {
    return std::span(points_).subspan(first_[n], first_[end] - first_[n]);
  }

  std::vector<Key> keys_;
  /// Indices of the points, those of a cube side by side, and where those of each cube begin.
  std::vector<int> points_;
  std::vector<std::size_t> first_;
};

}  // namespace quadrille
