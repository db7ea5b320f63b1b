#pragma once

#include <cstddef>
#include <vector>

#include "lab/scene/family.hpp"
#include "lab/scene/random.hpp"
#include "lab/scene/render.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::scene {

/// Labels of points that belong to no surface.
enum Label : int { kMixed = -2, kStray = -3 };

/// The points that a real depth camera would deliver, in row order without the missing ones.
struct View {
  std::vector<Eigen::Vector3f> points;
  /// Index of the surface, or a Label.
  std::vector<int> labels;
  /// True unit normals in frame C; NaN for labels below 0.
  std::vector<Eigen::Vector3f> normals;
  /// Index of the pixel, counted row by row.
  std::vector<std::size_t> pixels;
};

/// Share of the noise variance that neighbouring pixels have in common.
inline constexpr double kSmoothShare = 0.5;

/// Returns the standard deviation of the depth at depth z, for the family's noise factor [m].
double depth_noise(double factor, double z);

/// Adds noise, quantisation, missing pixels, mixed edges and strays to an ideal image.
View observe(const Camera& camera, const Rendering& ideal, const FamilyTraits& traits,
             Random* random);

/// Returns the points of a view as an organised cloud in frame C.
PointCloud organised_cloud(const Camera& camera, const View& view);

}  // namespace quadrille::scene
