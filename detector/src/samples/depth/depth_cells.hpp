#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// An image divided into square cells of several pixels, with the mean tangents and mean inverse
/// depth of the points in each cell. Inverse depth is affine in (u, v) on a plane, so averages keep
/// planes exact.
struct DepthCells {
  /// The image, which has square pixels.
  PinholeImage image;
  /// Edge of a cell [pixels].
  int pixels = 1;
  int width = 0, height = 0;
  /// Per cell: number of points (0 if empty), mean tangents u and v, and mean inverse depth w
  /// [1/m].
  std::vector<int> count;
  std::vector<float> u, v, w;
  /// Share of the cells within areas of layers, where points lie in clearly different depths. A
  /// single view has layers only along depth edges, so its share is near zero; a cloud fused from
  /// several views also shows surfaces that one view would hide.
  double layered = 0.0;

  int size() const { return width * height; }
  /// Step from one pixel to the next, as a tangent.
  float pitch() const { return image.pitch.x(); }
  /// Edge of a cell, as a tangent.
  float tangent() const { return pitch() * static_cast<float>(pixels); }
  /// Edge of a cell at inverse depth w [m].
  float metric(float w) const { return tangent() / w; }
  /// The cell that contains a point, given its tangents and inverse depth; −1 if the point lies
  /// outside the image or on the other side of a depth edge.
  int cell_of(const Eigen::Vector3f& uvw) const;
  /// The cells in whose directions points were seen, −1 outside the image or if unseen; depth edges
  /// do not matter.
  void look_up(const SeenPoints& points, std::array<int, SeenPoints::kSize>* cells) const;
  /// True if a point of inverse depth w_point in the direction of cell c is on no other side of a
  /// depth edge than the cell's own points.
  bool holds(int c, float w_point) const;
  /// Position of the mean of cell i in frame V [m].
  Eigen::Vector3f position_V(int i) const { return Eigen::Vector3f(u[i], v[i], 1.0f) / w[i]; }
};

/// Largest step in depth between neighbouring cells of one surface at inverse depth w [m]: the step
/// of a surface seen at 75° plus the noise, which grows with the square of the depth.
/// @param edge  of a cell, as a tangent
inline float continuous_step(float edge, float w) {
  constexpr float kSteepest = 3.7f, kNoisePerSquareMetre = 0.008f;
  return kSteepest * (edge / w) + kNoisePerSquareMetre / (w * w);
}

/// True if neighbouring cells of the given inverse depths may belong to one surface.
/// @param edge  of a cell, as a tangent
inline bool continuous(float edge, float w_a, float w_b) {
  // This compares |1/w_a - 1/w_b| with the step allowed at the farther cell.
  const float farther = w_b < w_a ? w_b : w_a;
  return std::abs(w_b - w_a) < continuous_step(edge, farther) * (w_a * w_b);
}

inline float continuous_step(const DepthCells& cells, float w) {
  return continuous_step(cells.tangent(), w);
}
inline bool continuous(const DepthCells& cells, float w_a, float w_b) {
  return continuous(cells.tangent(), w_a, w_b);
}

/// Averages the points over cells of the given number of pixels. A cell across a depth edge keeps
/// only the side with more points.
DepthCells make_depth_cells(const CloudView& cloud, const PinholeView& view,
                            const PinholeImage& image, int pixels);

}  // namespace quadrille
