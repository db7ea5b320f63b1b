#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "view/depth_bounds.hpp"
#include "view/depth_image.hpp"

namespace quadrille {

/// A cloud as the depth image of a pinhole camera at its viewpoint; tells which space the sensor
/// saw through.
///
/// Frame V: origin at the viewpoint, z forward. If the cloud has a regular grid of pixels
/// (organised, or stored row by row), it is recovered exactly; otherwise the pitch follows from the
/// density of the points. A pixel without support among its neighbours (a stray or mixed pixel)
/// counts as missing. A missing pixel inside a surface takes the smallest depth of its neighbours.
/// A missing pixel in the blind band beside an object's edge, or in a gap too narrow for any object
/// that matters, takes the depth up to which nothing can stand there. All others stay missing.
class DepthView {
 public:
  /// Depth below which a view tells nothing [m]: no depth camera measures nearer.
  static constexpr double kMinDepth = 0.02;

  /// @param baseline  largest distance between the sensor's two eyes [m]; 0 for a single eye
  /// @param thin  objects thinner than this may be hidden in gaps [m]
  explicit DepthView(const PointCloud& cloud, double baseline = 0.0, double thin = 0.0);

  /// Returns false if no point lies in front of the viewpoint, or the viewpoint is not finite.
  bool valid() const { return image_.width > 0; }
  int width() const { return image_.width; }
  int height() const { return image_.height; }
  const Eigen::Vector3d& p_CV() const { return p_CV_; }
  /// Transforms a point from frame C into frame V.
  Eigen::Vector3d to_view(const Eigen::Vector3d& p_C) const { return R_VC_ * (p_C - p_CV_); }
  /// The axes of C as columns, in frame V.
  const Eigen::Matrix3d& axes() const { return R_VC_; }
  /// Direction in C through the centre of pixel (u, v), with a depth of 1.
  Eigen::Vector3d ray_C(int u, int v) const {
    return R_VC_.transpose() * Eigen::Vector3d((u - cu_) * pitch_.x(), (v - cv_) * pitch_.y(), 1.0);
  }
  /// Distance between the rays of neighbouring pixels at a depth [m].
  double spacing(double depth) const { return pitch_.maxCoeff() * depth; }
  /// Depth at a pixel [m], 0 if missing or outside the image.
  double depth(int u, int v) const { return image_.at(u, v); }
  /// Pixel that p_V projects to (p_V.z > 0); it may lie outside the image.
  Eigen::Vector2i pixel(const Eigen::Vector3d& p_V) const;
  /// Half sizes, along the axes of V, of a cube of this half size whose edges lie along those of C.
  Eigen::Vector3d reach(double half) const { return half * spread_; }
  /// Bounds of the depth over all pixels whose rays may pass the box p_V ± reach. A box behind the
  /// viewpoint lies beyond both.
  DepthRange range(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const;
  /// Like range(), for eight boxes at once; their depths are rounded to within 1 µm.
  struct EightPoints {
    std::array<float, 8> x, y, z;
  };
  std::array<DepthRange, 8> ranges(const EightPoints& p_V, const Eigen::Vector3d& reach) const;
  /// Returns true if every pixel whose ray passes through the cube measured something beyond it.
  bool sees_past(const Eigen::Vector3d& centre_C, double half) const;
  /// Returns the smallest depth measured by any pixel whose ray may pass through the box p_V ±
  /// reach [m]: infinite if none measured anything, 0 for a box that reaches the sensor.
  double nearest_surface(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const;
  /// Returns true if a pixel whose ray passes through the cube measured something in front of it or
  /// in it; false beside the image and where nothing was measured.
  bool meets_surface(const Eigen::Vector3d& centre_C, double half) const;
  /// Returns true if some of the pixels whose rays pass through the cube did not see past it, and
  /// holds(p_C) is true for the point that each of them measured. For a pixel without a measurement
  /// in a narrow gap, the nearer of the two points at the ends of the gap is used: beside the edge
  /// of an object, a stereo or structured-light sensor is blind where the object stands between the
  /// surface and its second eye.
  bool hidden_only_by(const Eigen::Vector3d& centre_C, double half,
                      const std::function<bool(const Eigen::Vector3d&)>& holds) const;
  /// For each point of the cloud, nonzero if it was rejected as a stray.
  const std::vector<std::uint8_t>& stray() const { return stray_; }

 private:
  template <class Visitor>
  bool visit_blockers(const Eigen::Vector3d& centre_C, double half, Visitor&& visit) const;
  PixelSpan span(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const;
  struct EightSpans;
  EightSpans spans(const EightPoints& p_V, const Eigen::Vector3f& reach) const;
  /// Returns the column of the nearer measured pixel at the ends of the gap at (u, v); -1 if there
  /// is none.
  int nearer_end_of_gap(int u, int v) const;
  bool measured(int u, int v) const { return measured_.at(u, v) > 0.0f; }
  void place(const PinholeView& view, const PinholeImage& image);
  struct Projected;
  void project(Projected& points) const;
  void keep_nearest(const PointCloud& cloud);

  Eigen::Matrix3d R_VC_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d spread_ = Eigen::Vector3d::Ones();
  Eigen::Vector3d p_CV_ = Eigen::Vector3d::Zero();
  /// Tangent of the angle between neighbouring pixels along u and v, and its inverse, pixels per
  /// unit of tangent.
  Eigen::Array2d pitch_ = Eigen::Array2d::Ones(), pixels_ = Eigen::Array2d::Ones();
  /// Pixel coordinates at which the axis of V passes through the image.
  double cu_ = 0.0, cv_ = 0.0;
  /// The measured depths with holes filled, and the same with depths that bound what gaps may hide.
  DepthImage measured_, image_;
  DepthBounds bounds_;
  std::vector<std::uint8_t> stray_;
};

/// Returns true if one of the views sees past the cube; see DepthView::sees_past().
bool any_sees_past(std::span<const DepthView> views, const Eigen::Vector3d& centre_C, double half);

}  // namespace quadrille
