#pragma once

#include <Eigen/Core>
#include <vector>

#include "hand/oriented_box.hpp"

namespace quadrille {

/// Measured points that a hand must not touch. They are tested one by one and so more exactly than
/// voxels, which are several millimetres wide: this matters close to a target, whose own voxels
/// give way.
class ObstaclePoints {
 public:
  ObstaclePoints() = default;
  /// @param points_C  positions, in frame C [m]
  explicit ObstaclePoints(const std::vector<Eigen::Vector3d>& points_C);

  /// Returns true if a point lies in the box.
  bool meet(const OrientedBox& box) const;

 private:
  using Points = Eigen::Matrix<float, Eigen::Dynamic, 3>;
  /// The bounds of some neighbouring cubes' points [m].
  struct Bounds {
    Eigen::Array3f low, high;
  };

  /// The points, those of a cube side by side; where those of each cube begin, and their middle.
  Points points_C_, centres_C_;
  std::vector<Eigen::Index> first_;
  /// The bounds of each kRun cubes.
  std::vector<Bounds> runs_;
};

}  // namespace quadrille
