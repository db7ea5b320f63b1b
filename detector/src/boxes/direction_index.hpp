#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Indexes the points of a cloud by the direction in which they were seen.
class DirectionIndex {
 public:
  /// @param cloud  its points must outlive this object
  explicit DirectionIndex(const CloudView& cloud);

  /// True if the cloud is a single view, so that nothing stands between the eye and a point.
  bool single() const { return view_.has_value(); }
  /// Position of the sensor in frame C [m].
  const Eigen::Vector3d& eye() const { return cloud_.viewpoint; }
  /// Returns the points seen in the direction of the convex hull of some places, and some around
  /// it. If they are more than a box needs, they are thinned evenly over the image. If the cloud is
  /// not a single view, returns the points within the bounding box of the places.
  /// @param margin  least distance beside the places that is included [m]
  std::vector<Eigen::Vector3d> points_towards(std::span<const Eigen::Vector3d> places_C,
                                              double margin) const;

 private:
  /// Keeps one of a level's points in each cell of a grid with about so many cells over the image.
  /// @param tangents  of each point of the cloud
  Buckets thinned(const Buckets& level, const std::vector<Eigen::Vector2f>& tangents,
                  double cells) const;
  Eigen::Vector2i tile_of(const Eigen::Vector2f& tangents) const;
  std::vector<Eigen::Vector3d> points_in(const Eigen::Vector2i& low,
                                         const Eigen::Vector2i& high) const;
  std::vector<Eigen::Vector3d> points_within(const Eigen::AlignedBox3d& bounds_C) const;

  CloudView cloud_;
  std::optional<PinholeView> view_;
  /// The points of the cloud in each tile: all points first, then ever fewer, evenly spread over
  /// the image, until they are no more than a box needs.
  std::vector<Buckets> levels_;
};

}  // namespace quadrille
