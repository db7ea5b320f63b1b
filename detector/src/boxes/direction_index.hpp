#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/pinhole.hpp"

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
  /// The points' indices tile by tile, and the position at which each tile begins among them.
  struct Level {
    std::vector<int> begin, points;
  };

  /// A level together with the tangents of each of its points.
  struct SeenByTile {
    Level level;
    std::vector<Eigen::Vector2f> tangents;
  };

  SeenByTile by_tile(std::span<const Eigen::Vector3f> points) const;
  /// Keeps one point in each cell of a grid with about so many cells over the image.
  static void thin(const Eigen::AlignedBox2f& image, double cells, SeenByTile* seen);
  Eigen::Vector2i tile_of(const Eigen::Vector2f& tangents) const;
  std::vector<Eigen::Vector3d> points_in(const Eigen::Vector2i& low,
                                         const Eigen::Vector2i& high) const;
  std::vector<Eigen::Vector3d> points_within(const Eigen::AlignedBox3d& bounds_C) const;

  CloudView cloud_;
  std::optional<PinholeView> view_;
  /// All points first, then ever fewer, evenly spread over the image.
  std::vector<Level> levels_;
};

}  // namespace quadrille
