#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/pinhole.hpp"

namespace quadrille {

/// The points of a cloud by the direction in which they were seen.
class DirectionIndex {
 public:
  /// @param cloud  its points must outlive this
  explicit DirectionIndex(const CloudView& cloud);

  /// True if the cloud is a single view: nothing stands between the eye and a point.
  bool single() const { return view_.has_value(); }
  /// Where the sensor stood [m].
  const Eigen::Vector3d& eye() const { return cloud_.viewpoint; }
  /// The points that were seen towards the convex hull of some places, and some around them; where
  /// they are more than a box needs, some of them, evenly spread over the image. Of no single view
  /// the points within the bounds of the places.
  /// @param margin  how far beside the places, at least [m]
  std::vector<Eigen::Vector3d> points_towards(std::span<const Eigen::Vector3d> places_C,
                                              double margin) const;

 private:
  /// Points of the cloud tile by tile, and where each tile begins among them.
  struct Level {
    std::vector<int> begin, points;
  };

  /// With the tangents of each point.
  struct SeenByTile {
    Level level;
    std::vector<Eigen::Vector2f> tangents;
  };

  SeenByTile by_tile(std::span<const Eigen::Vector3f> points) const;
  /// Keeps one point in each of so many cells of the image.
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
