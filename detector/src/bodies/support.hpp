#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Distance from a support within which a body stands on it [m]: the foot is rounded, or the sensor
/// mixes it with the support.
inline constexpr double kMaxFootGap = 0.02;

/// Places on planes [m]: by the ids of the planes, and then for each view of the scene.
using PlacesOnPlanes = std::map<int, std::vector<std::vector<Eigen::Vector3d>>>;

/// A plane on which bodies may stand.
struct Support {
  int id = 0;
  /// Unit normal towards the sensor, and offset of the plane n·x = offset [m].
  Eigen::Vector3d n_C = Eigen::Vector3d::UnitZ();
  double offset = 0.0;
  Eigen::Isometry3d X_QC = Eigen::Isometry3d::Identity();
  Eigen::AlignedBox2d bounds_Q;
  /// For each view, the corners of the convex hull of the places that it sees on the plane,
  /// counterclockwise in Q [m]; empty if no places are known.
  std::vector<std::vector<Eigen::Vector2d>> outlines_Q;

  double height(const Eigen::Vector3d& p_C) const { return n_C.dot(p_C) - offset; }
  /// True if a place is on the sensor's side of the plane and over the part that was seen, or
  /// within a tenth of its size beside it.
  bool is_below(const Eigen::Vector3d& p_C) const;
  /// Distance of a place from the edge of the part that a view sees, along the plane; negative
  /// outside of that part [m].
  double inside(const Eigen::Vector3d& p_C, std::size_t view) const;
};

/// The planes among the detections that are no parts of bodies, the largest first.
/// @param parts  ids of the detections that are parts of bodies
/// @param places_C  places on the planes, by id
std::vector<Support> supports_of(const std::vector<Detection>& detections,
                                 const std::vector<int>& parts, const PlacesOnPlanes& places_C);

/// The support nearest below a place; nullptr if there is none.
const Support* support_below(const std::vector<Support>& supports, const Eigen::Vector3d& p_C);

/// The support on which something stands that occupies these places. It lies below their middle,
/// and the lowest of them is on it; if there are several, the one nearest to the lowest place.
/// Nullopt if there is none.
std::optional<int> standing_on(const std::vector<Support>& supports,
                               std::span<const Eigen::Vector3d> places_C);

}  // namespace quadrille
