#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// This many points suffice to judge a box.
inline constexpr std::size_t kMaxPoints = 12'000;

/// Indexes the points of a cloud by the direction in which they were seen.
class DirectionIndex {
 public:
  /// @param cloud  its points must outlive this object
  explicit DirectionIndex(const CloudView& cloud) : DirectionIndex(cloud, find_view(cloud)) {}
  /// @param view  what find_view() returns for the cloud, if it is known
  DirectionIndex(const CloudView& cloud, const std::optional<PinholeView>& view);

  /// True if the cloud is a single view, so that nothing stands between the eye and a point.
  bool single() const { return view_.has_value(); }
  /// Position of the sensor in frame C [m].
  const Eigen::Vector3d& eye() const { return cloud_.viewpoint; }
  /// Returns the points seen in the direction of the convex hull of some places, and some around
  /// it. If the cloud is not a single view, returns the points within the bounding box of the
  /// places.
  /// @param margin      least distance beside the places that is included [m]
  /// @param max_points  if there are more in a single view, they are thinned evenly over the image
  std::vector<Eigen::Vector3d> points_towards(std::span<const Eigen::Vector3d> places_C,
                                              double margin,
                                              std::size_t max_points = kMaxPoints) const;

 private:
  /// A rectangle of tiles, the last ones included.
  struct Tiles {
    Eigen::Vector2i low, high;
  };

  Eigen::Vector2i tile_of(const Eigen::Vector2f& tangents) const;
  /// The points in some adjacent tiles of a row of tiles.
  std::span<const int> points_in(int row, int from, int to) const;
  /// The first point in each square block of tiles that overlaps a rectangle.
  /// @param side  of the blocks, in tiles
  std::vector<Eigen::Vector3d> thinned(const Tiles& tiles, int side) const;
  std::vector<Eigen::Vector3d> points_within(const Eigen::AlignedBox3d& bounds_C) const;

  CloudView cloud_;
  std::optional<PinholeView> view_;
  /// Number of tiles along the sides of the image, and per unit of the tangents.
  int width_ = 1, height_ = 1;
  float per_unit_ = 1.0f;
  /// The points in each tile, row by row. A tile of a full image holds about four.
  Buckets tiles_;
};

}  // namespace quadrille
