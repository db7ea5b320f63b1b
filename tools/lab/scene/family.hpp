#pragma once

namespace quadrille::scene {

/// Families of scenes by difficulty: number and spacing of bodies, noise, and mutual occlusion. A
/// bin is a tray of equal cylinders (bin.hpp).
enum class Family { kEasy, kMedium, kHard, kTabletop, kBin };

/// Settings of a family.
struct FamilyTraits {
  const char* name;
  int min_quadrics, max_quadrics, min_boxes, max_boxes;
  /// Bounds of the factor on body sizes.
  double min_scale, max_scale;
  /// Bounds of the tangent of half the camera's elevation above the table.
  double min_elevation, max_elevation;
  /// Radius around the middle of the table within which bodies stand, and the least gap between
  /// them [m].
  double radius, gap;
  /// Bounds of the occlusion of each quadric, and of its mean over the quadrics.
  double max_occlusion, min_mean_occlusion, max_mean_occlusion;
  /// Factor on the depth noise, and whether depth is quantised in disparity instead of millimetres.
  double noise;
  bool disparity;
};

const FamilyTraits& traits_of(Family family);

}  // namespace quadrille::scene
