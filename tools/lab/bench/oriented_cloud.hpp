#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace quadrille::bench {

/// Points with normals: the input of all contenders except quadrille itself.
struct OrientedCloud {
  std::vector<Eigen::Vector3f> points;
  /// Unit normals that point towards the camera.
  std::vector<Eigen::Vector3f> normals;
};

/// How a cloud is thinned and given normals.
struct OrientationOptions {
  /// Edge of the voxels; each voxel's points are replaced by their centroid [m].
  double voxel = 0.006;
  /// Radius of the balls in which planes are fitted for the normals [m].
  double normal_radius = 0.015;
};

/// Returns the centroids of voxels with at least two points, with normals from principal
/// components. Centroids with too few neighbours are left out. The camera is at the origin.
OrientedCloud orient(const std::vector<Eigen::Vector3f>& points, const OrientationOptions& options);

/// Finds the points of a list that lie within a ball.
class NeighbourSearch {
 public:
  /// @param points  must outlive this object
  explicit NeighbourSearch(const std::vector<Eigen::Vector3f>& points);
  ~NeighbourSearch();

  /// Returns the indices in ascending order.
  std::vector<int> within(const Eigen::Vector3f& p, double radius) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace quadrille::bench
