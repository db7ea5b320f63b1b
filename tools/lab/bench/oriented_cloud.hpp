#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace quadrille::bench {

/// Points with normals: what all contenders but quadrille itself start from.
struct OrientedCloud {
  std::vector<Eigen::Vector3f> points;
  /// Unit length, towards the camera.
  std::vector<Eigen::Vector3f> normals;
};

/// How a cloud is thinned and given normals.
struct OrientationOptions {
  /// Edge of the voxels, whose centroids take the place of the points [m].
  double voxel = 0.006;
  /// Radius of the balls whose planes give the normals [m].
  double normal_radius = 0.015;
};

/// Centroids of voxels with two points or more, with normals by principal components; without those
/// that have too few neighbours. The camera is at the origin.
OrientedCloud orient(const std::vector<Eigen::Vector3f>& points, const OrientationOptions& options);

/// Finds the points of a list within balls.
class NeighbourSearch {
 public:
  /// @param points  must outlive this
  explicit NeighbourSearch(const std::vector<Eigen::Vector3f>& points);
  ~NeighbourSearch();

  /// Indices in ascending order.
  std::vector<int> within(const Eigen::Vector3f& p, double radius) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace quadrille::bench
