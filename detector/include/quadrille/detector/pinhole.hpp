#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Some points as seen by a pinhole camera: tangents u = x/z and v = y/z, and inverse depth w = 1/z
/// [1/m]. All are 0 for a point that is missing or outside the field of view.
struct SeenPoints {
  static constexpr int kSize = 16;
  std::array<float, kSize> u, v, w;
};

/// A pinhole camera at a cloud's viewpoint, and what it sees of the cloud.
struct PinholeView {
  /// Largest half field of view, as a tangent: 63°. Depth cameras have 60° at most, and pixels
  /// farther out would be stretched more than twofold.
  static constexpr float kMaxTangent = 2.0f;
  /// Range of inverse depths within which points are seen [1/m]. No real point is a tenth of a
  /// millimetre or a million kilometres from a lens; such values stand for missing points. Squares
  /// of inverse depths within the range keep full precision.
  static constexpr float kMinInverseDepth = 1e-9f, kMaxInverseDepth = 1e4f;

  /// Pose of the cloud's frame in frame V, whose origin is the viewpoint and whose z points into
  /// the scene.
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  /// Only every stride-th point is looked at, and pixels are wider accordingly.
  int stride = 1;
  /// Number of points that lie in the field of view, and of finite points that do not.
  std::size_t seen = 0, unseen = 0;
  /// Bounds of the tangents (u, v) of the points that it sees.
  Eigen::AlignedBox2f bounds;

  /// Returns (u, v, w) of a point p_C [m], as in SeenPoints.
  Eigen::Vector3f operator()(const Eigen::Vector3f& p_C) const {
    const Eigen::Matrix4f& X = X_VC.matrix();
    const auto row = [&](int r) {
      return X(r, 0) * p_C.x() + X(r, 1) * p_C.y() + X(r, 2) * p_C.z() + X(r, 3);
    };
    const float w = 1.0f / row(2), u = row(0) * w, v = row(1) * w;
    // This is false also for NaN. The operators && and || would keep the compiler from vectorising.
    const bool inside = (w > kMinInverseDepth) & (w < kMaxInverseDepth) &
                        (std::abs(u) < kMaxTangent) & (std::abs(v) < kMaxTangent);
    return {inside ? u : 0.0f, inside ? v : 0.0f, inside ? w : 0.0f};
  }

  /// Number of points that are looked at in a cloud of the given size.
  std::size_t looked_at(std::size_t points) const {
    const std::size_t step = static_cast<std::size_t>(stride);
    return (points + step - 1) / step;
  }
  /// Looks at kSize of these points from the k-th on; entries past the end count as missing.
  QUADRILLE_EXPORT SeenPoints look(std::span<const Eigen::Vector3f> points, std::size_t k) const;
};

/// Looks at a cloud from its viewpoint: along z of the cloud's frame if all points lie there, as in
/// a camera's own frame, otherwise towards the middle of the points. Nullopt if it sees none.
QUADRILLE_EXPORT std::optional<PinholeView> look_from_viewpoint(const CloudView& cloud,
                                                                int stride = 1);

/// Calls look_from_viewpoint(), but returns nullopt also if the cloud is not a single view: too
/// small, or not all within a pinhole's field of view.
QUADRILLE_EXPORT std::optional<PinholeView> find_view(const CloudView& cloud, int stride = 1);

/// The grid of pixels that a view fills.
struct PinholeImage {
  /// Tangents of the first pixel's corner with the smallest u and v, and steps from pixel to pixel
  /// along u and v.
  Eigen::Array2f corner = Eigen::Array2f::Zero(), pitch = Eigen::Array2f::Zero();
  /// Size in pixels.
  int width = 0, height = 0;
};

/// Finds pitch and phase of square pixels from the points themselves: from the steps between
/// consecutive points if these come row by row, otherwise from their density. Nullopt if the points
/// fill no image.
QUADRILLE_EXPORT std::optional<PinholeImage> find_image(const CloudView& cloud,
                                                        const PinholeView& view);

/// Finds the pixels of a depth image. If the points repeat so regularly that each falls into a
/// pixel of its own, the pixels have separate pitches along u and v; otherwise they are so coarse
/// that a typical pixel holds two points. Pixels are made coarser if there would be more than
/// max_pixels.
QUADRILLE_EXPORT PinholeImage find_pixels(const CloudView& cloud, const PinholeView& view,
                                          double max_pixels);

}  // namespace quadrille
