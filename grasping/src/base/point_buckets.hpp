#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace quadrille {

/// Points sorted into cubes, to find those near a place.
class PointBuckets {
 public:
  using Key = std::array<int, 3>;

  /// @param points_C  positions in frame C [m]
  /// @param edge  edge of a cube [m]
  PointBuckets(std::span<const Eigen::Vector3d> points_C, double edge);

  /// Returns the cube of edge `edge` [m] that holds a point.
  static Key key_of(const Eigen::Vector3d& p_C, double edge);

  /// The cubes that hold points, in ascending order.
  const std::vector<Key>& keys() const { return keys_; }
  /// The indices of the points in the n-th of these cubes, in ascending order.
  std::span<const int> members(std::size_t n) const {
    return std::span(points_).subspan(first_[n], first_[n + 1] - first_[n]);
  }

  /// Returns the indices of the points in a cube and its 26 neighbours: all points that are nearer
  /// than an edge to any place in the cube, and some farther ones.
  std::vector<int> near(const Key& key) const;

 private:
  std::vector<Key> keys_;
  /// Indices of the points, those of a cube side by side, and where those of each cube begin.
  std::vector<int> points_;
  std::vector<std::size_t> first_;
};

}  // namespace quadrille
