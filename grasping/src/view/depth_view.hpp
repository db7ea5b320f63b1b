#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// What the pixels of a region measured.
struct DepthRange {
  /// Least and largest depth [m]; near is 0 where a pixel is missing.
  double near = 0.0, far = 0.0;
};

/// A cloud as the depth image of a pinhole at its viewpoint: which space the sensor saw through.
///
/// Frame V: origin at the viewpoint, z forward. A regular grid of pixels, as an organised cloud or
/// one stored row by row has, is recovered exactly; otherwise the pitch follows from the density of
/// the points. A pixel without support among its neighbours (a stray or mixed pixel) counts as
/// missing; a missing pixel inside a surface takes the least depth of its neighbours; in the
/// blind band beside the edge of a thing, and in gaps too narrow for anything that counts, it takes
/// the depth up to which nothing can stand there; others stay missing.
class DepthView {
 public:
  /// @param baseline  largest distance between the sensor's two eyes [m]; 0 for a single eye
  /// @param thin      things thinner than this may hide in gaps [m]
  explicit DepthView(const PointCloud& cloud, double baseline = 0.0, double thin = 0.0);

  /// False if no point lies before the viewpoint, or the viewpoint is not finite.
  bool valid() const { return width_ > 0; }
  int width() const { return width_; }
  int height() const { return height_; }
  const Eigen::Vector3d& p_CV() const { return p_CV_; }
  /// Point of frame C in frame V.
  Eigen::Vector3d to_view(const Eigen::Vector3d& p_C) const { return R_VC_ * (p_C - p_CV_); }
  /// The axes of C as columns, in frame V.
  const Eigen::Matrix3d& axes() const { return R_VC_; }
  /// Direction in C through the centre of pixel (u, v), of unit depth.
  Eigen::Vector3d ray_C(int u, int v) const {
    return R_VC_.transpose() * Eigen::Vector3d((u - cu_) * pitch_u_, (v - cv_) * pitch_v_, 1.0);
  }
  /// Distance between the rays of neighbouring pixels at a depth [m].
  double spacing(double depth) const { return std::max(pitch_u_, pitch_v_) * depth; }
  /// Depth at a pixel [m], 0 if missing or outside the image.
  double depth(int u, int v) const;
  /// Pixel that p_V projects to (p_V.z > 0); may lie outside the image.
  Eigen::Vector2i pixel(const Eigen::Vector3d& p_V) const;
  /// Half sizes along the axes of V of a cube with edges along those of C and of that half size.
  Eigen::Vector3d reach(double half) const { return half * spread_; }
  /// Bounds of the depth over all pixels whose rays may pass the box p_V ± reach.
  DepthRange range(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const;
  /// The same for eight boxes at once, to within 1 µm of the depths asked about.
  using EightPoints = Eigen::Array<float, 8, 3>;
  std::array<DepthRange, 8> ranges(const EightPoints& p_V, const Eigen::Vector3d& reach) const;
  /// True if each pixel whose ray passes the cube measured something beyond it.
  bool sees_past(const Eigen::Vector3d& centre_C, double half) const;
  /// Least depth that any pixel whose ray may pass the box p_V ± reach measured [m]: infinite if
  /// none measured anything, 0 for a box that reaches the sensor.
  double nearest_surface(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const;
  /// True if one of these pixels measured something before the cube or in it. False beside the
  /// image and where nothing was measured.
  bool meets_surface(const Eigen::Vector3d& centre_C, double half) const;
  /// True if some of those pixels did not see past it, and holds(p_C) of the point that each of
  /// these measured. A pixel that measured nothing counts with the nearer of the two points at the
  /// ends of its gap, if the gap is narrow: beside the edge of a thing, a stereo or
  /// structured-light sensor is blind where the thing stands between the surface and its second
  /// eye.
  template <class Holds>
  bool hidden_only_by(const Eigen::Vector3d& centre_C, double half, Holds&& holds) const;
  /// For each point of the cloud, whether it was refused as a stray.
  const std::vector<std::uint8_t>& stray() const { return stray_; }

 private:
  struct Level {
    int width = 0, height = 0;
    /// Of the pixels that measured something, `surface` is the least depth, infinite if none did.
    std::vector<float> near, far, surface;
  };
  struct Span {
    int u0, u1, v0, v1;
  };

  template <class Visitor>
  bool all_blockers(const Eigen::Vector3d& centre_C, double half, Visitor&& visit) const;
  Span span(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const;
  DepthRange range(const Span& span) const;
  double nearest_surface(const Span& span) const;
  std::vector<float> surface() const;
  int level_of(int across_u, int across_v) const;
  /// Column of the nearer measured pixel at the ends of the gap at (u, v); -1 if there is none.
  int nearer_end_of_gap(int u, int v) const;
  bool measured(int u, int v) const {
    return depth(u, v) > 0.0 && !filled_[static_cast<std::size_t>(v) * width_ + u];
  }
  /// The points before the sensor: where in the image (x/z and y/z in V), how deep, and which.
  struct Projected {
    std::vector<Eigen::Vector2d> tangents;
    std::vector<float> depths;
    std::vector<int> points;
  };
  void choose_axes(const PointCloud& cloud);
  Projected project(const PointCloud& cloud) const;
  void choose_grid(const std::vector<Eigen::Vector2d>& tangents);
  void keep_nearest(const Projected& seen);
  void refuse_strays(const std::vector<int>& nearest);
  void fill_holes();
  void build_levels();

  Eigen::Matrix3d R_VC_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d spread_ = Eigen::Vector3d::Ones();
  Eigen::Vector3d p_CV_ = Eigen::Vector3d::Zero();
  int width_ = 0, height_ = 0;
  double pitch_u_ = 1.0, pitch_v_ = 1.0, cu_ = 0.0, cv_ = 0.0;
  /// Pixels per unit of the tangent.
  double pixels_u_ = 1.0, pixels_v_ = 1.0;
  std::vector<float> depth_;
  /// For each pixel, whether its depth bounds what a gap may hide, not measured.
  std::vector<std::uint8_t> filled_;
  std::vector<Level> levels_;
  std::vector<std::uint8_t> stray_;
};

// Calls visit(u, v, depth) for each pixel whose ray passes the cube without seeing past it, until
// one call returns false. The pixel that the centre projects to counts in any case.
template <class Visitor>
bool DepthView::all_blockers(const Eigen::Vector3d& centre_C, double half, Visitor&& visit) const {
  const Eigen::Vector3d p_V = to_view(centre_C);
  const Eigen::Vector3d around = reach(half);
  const double beyond = p_V.z() + around.z();
  if (p_V.z() - around.z() <= 0.0) return visit(-1, -1, 0.0);
  const Eigen::Array3d to_low = (centre_C - p_CV_).array() - half;
  const Eigen::Vector2i middle = pixel(p_V);
  const double z_middle = depth(middle.x(), middle.y());
  if (z_middle <= p_V.z() && !visit(middle.x(), middle.y(), z_middle)) return false;
  const Span s = span(p_V, around);
  for (int v = s.v0; v <= s.v1; ++v) {
    for (int u = s.u0; u <= s.u1; ++u) {
      const double z = depth(u, v);
      if (z > beyond) continue;
      const Eigen::Array3d inverse = ray_C(u, v).array().inverse();
      const Eigen::Array3d t0 = to_low * inverse, t1 = (to_low + 2.0 * half) * inverse;
      const double enter = t0.min(t1).maxCoeff(), leave = t0.max(t1).minCoeff();
      if (enter <= leave && z <= leave && !visit(u, v, z)) return false;
    }
  }
  return true;
}

template <class Holds>
bool DepthView::hidden_only_by(const Eigen::Vector3d& centre_C, double half, Holds&& holds) const {
  int blockers = 0;
  const bool all = all_blockers(centre_C, half, [&](int u, int v, double z) {
    ++blockers;
    const int edge = z > 0.0 && measured(u, v) ? u : nearer_end_of_gap(u, v);
    if (edge < 0) return false;
    return holds(Eigen::Vector3d(p_CV_ + depth(edge, v) * ray_C(edge, v)));
  });
  return all && blockers > 0;
}

}  // namespace quadrille
