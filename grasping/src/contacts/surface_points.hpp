#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/point_buckets.hpp"

namespace quadrille {

/// Points of a surface, thinned to one for each small cell, with its normals.
struct SurfacePoints {
  /// Positions in frame C [m].
  std::vector<Eigen::Vector3d> p_C;
  /// Unit normals towards the sensor; zero where there are too few points for one.
  std::vector<Eigen::Vector3d> n_C;
};

/// Thins points to the mean of those in each cell, and takes the normals from the neighbours of
/// each mean by principal components. Where one sensor's points end and another's begin there is a
/// step that is no surface, because their views are a little off; so each mean and each normal is
/// taken from one sensor's points. The order of the result depends on the positions and the sensors
/// alone.
///
/// Points are thinned at once, but most are never asked for, so each normal is computed when it is
/// asked for first. Several threads may ask at once.
class PointSurface {
 public:
  /// @param points_C  positions, in frame C [m]
  /// @param cell  edge of a cell [m]; normals are taken over some three cells around a point
  /// @param eyes_C  for each point, the position of the sensor that saw it [m], or a single one for
  ///   all points
  PointSurface(std::span<const Eigen::Vector3d> points_C, double cell,
               std::span<const Eigen::Vector3d> eyes_C);
  // Groups and rows refer to the memory of the buckets, which a move keeps and a copy would not.
  PointSurface(PointSurface&&) = default;
  PointSurface(const PointSurface&) = delete;
  PointSurface& operator=(const PointSurface&) = delete;

  /// Returns the points in a box, in their order.
  SurfacePoints within(const Eigen::AlignedBox3d& box_C) const;
  /// Returns all points.
  SurfacePoints all() const;

 private:
  /// Some points of one cube of the buckets, as many as are processed side by side.
  struct Group {
    std::size_t cube;
    std::span<const int> points;
  };
  enum class State : std::uint8_t { kNone, kBusy, kReady };

  void make_groups();
  Eigen::Vector3d normal(std::size_t point) const;

  double reach_;
  std::vector<Eigen::Vector3d> points_C_, eyes_C_;
  /// For each point, the index of its eye.
  std::vector<int> eye_of_;
  PointBuckets buckets_;
  std::vector<PointBuckets::Near> near_;
  std::vector<Group> groups_;
  /// For each point, the index of its group.
  std::vector<std::size_t> group_of_;
  /// The normals of the points of the groups that are ready.
  mutable std::vector<Eigen::Vector3d> normals_C_;
  mutable std::vector<std::atomic<State>> states_;
};

/// Returns all points of a surface at once.
SurfacePoints surface_points(std::span<const Eigen::Vector3d> points_C, double cell,
                             std::span<const Eigen::Vector3d> eyes_C);

}  // namespace quadrille
