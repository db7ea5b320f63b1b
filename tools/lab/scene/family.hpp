#pragma once

namespace quadrille::scene {

/// How hard a scene is: number and nearness of bodies, noise, and how much they hide each other.
enum class Family { kEasy, kMedium, kHard, kTabletop };

/// Settings of a family.
struct FamilyTraits {
  const char* name;
  int min_quadrics, max_quadrics, min_boxes, max_boxes;
  /// Factor on body sizes.
  double min_scale, max_scale;
  /// Tangent of half the camera's elevation above the table.
  double min_elevation, max_elevation;
  /// Radius about the middle of the table that bodies stand in, and least gap between them [m].
  double radius, gap;
  /// Bounds on the occlusion of each quadric, and on its mean over the quadrics.
  double max_occlusion, min_mean_occlusion, max_mean_occlusion;
  /// Factor on the depth noise, and whether depth is quantised in disparity instead of millimetres.
  double noise;
  bool disparity;
};

const FamilyTraits& traits_of(Family family);

}  // namespace quadrille::scene
