#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// What one pixel measured.
struct DepthRange {
  /// Least and largest depth within a region of the image [m]; near is 0 where a pixel is missing.
  double near = 0.0, far = 0.0;
};

/// A cloud as the depth image of a pinhole at its viewpoint: which space the sensor saw through.
///
/// Frame V: origin at the viewpoint, z forward. A regular grid of pixels, as an organised cloud or
/// one stored row by row has, is recovered exactly; otherwise the pitch follows from the density of
/// the points. A pixel without support among its neighbours (a stray or mixed pixel) counts as
/// missing; a missing pixel inside a surface takes the least depth of its neighbours, others stay
/// missing.
class DepthView {
 public:
  explicit DepthView(const PointCloud& cloud);

  /// False if no point lies before the viewpoint, or the viewpoint is not finite.
  bool valid() const { return width_ > 0; }
  int width() const { return width_; }
  int height() const { return height_; }
  const Eigen::Vector3d& p_CV() const { return p_CV_; }
  /// Point of frame C in frame V.
  Eigen::Vector3d to_view(const Eigen::Vector3d& p_C) const { return R_VC_ * (p_C - p_CV_); }
  /// Direction in C through the centre of pixel (u, v), of unit depth.
  Eigen::Vector3d ray_C(int u, int v) const {
    return R_VC_.transpose() * Eigen::Vector3d((u - cu_) * pitch_u_, (v - cv_) * pitch_v_, 1.0);
  }
  /// Depth at a pixel [m], 0 if missing or outside the image.
  double depth(int u, int v) const;
  /// Pixel that p_V projects to (p_V.z > 0); may lie outside the image.
  Eigen::Vector2i pixel(const Eigen::Vector3d& p_V) const;
  /// Bounds of the depth over all pixels whose rays may pass the ball of that radius around p_V.
  DepthRange range(const Eigen::Vector3d& p_V, double radius) const;
  /// True if each pixel whose ray passes the cube measured something beyond it, and one does.
  bool sees_past(const Eigen::Vector3d& centre_C, double half) const;
  /// For each point of the cloud, whether it was refused as a stray.
  const std::vector<std::uint8_t>& stray() const { return stray_; }

 private:
  struct Level {
    int width = 0, height = 0;
    std::vector<float> near, far;
  };
  struct Span {
    int u0, u1, v0, v1;
  };

  Span span(const Eigen::Vector3d& p_V, double radius) const;
  void choose_axes(const PointCloud& cloud);
  void choose_grid(const PointCloud& cloud);
  void project(const PointCloud& cloud);
  void refuse_strays(const std::vector<int>& nearest);
  void fill_holes();
  void build_levels();

  Eigen::Matrix3d R_VC_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_CV_ = Eigen::Vector3d::Zero();
  int width_ = 0, height_ = 0;
  double pitch_u_ = 1.0, pitch_v_ = 1.0, cu_ = 0.0, cv_ = 0.0;
  std::vector<float> depth_;
  std::vector<Level> levels_;
  std::vector<std::uint8_t> stray_;
};

}  // namespace quadrille
