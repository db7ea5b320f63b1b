#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
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

  /// The indices of the points of each cube that holds any.
  const std::map<Key, std::vector<int>>& all() const { return buckets_; }

  /// Returns the indices of the points in a cube and its 26 neighbours: all points that are nearer
  /// than an edge to any place in the cube, and some farther ones.
  std::vector<int> near(const Key& key) const;

 private:
  std::map<Key, std::vector<int>> buckets_;
};

}  // namespace quadrille
