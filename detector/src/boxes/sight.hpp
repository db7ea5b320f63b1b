#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// The points of a cloud by the direction in which they were seen.
class Sight {
 public:
  /// @param cloud  must outlive this
  explicit Sight(const PointCloud& cloud);

  /// True if the cloud is a single view: nothing stands between the eye and a point.
  bool single() const { return view_.has_value(); }
  /// Where the sensor stood [m].
  const Eigen::Vector3d& eye() const { return cloud_->viewpoint; }
  /// The points that were seen towards the convex hull of some places, and some around them; of no
  /// single view the points within the bounds of the places.
  /// @param margin  how far beside the places, at least [m]
  std::vector<Eigen::Vector3d> points_towards(std::span<const Eigen::Vector3d> places_C,
                                              double margin) const;

 private:
  Eigen::Vector2i tile_of(const Eigen::Vector2f& tangents) const;
  std::vector<Eigen::Vector3d> points_within(const Eigen::AlignedBox3d& bounds_C) const;

  const PointCloud* cloud_;
  std::optional<PinholeView> view_;
  /// For each tile where its points begin in order_.
  std::vector<int> begin_, order_;
};

}  // namespace quadrille
