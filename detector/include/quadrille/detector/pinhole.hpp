#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Some points as a pinhole sees them: tangents u = x/z and v = y/z, and inverse depth w = 1/z
/// [1/m]. All are 0 for a point that is missing or outside the field of view.
struct SeenPoints {
  static constexpr int kSize = 16;
  std::array<float, kSize> u, v, w;
};

/// How a pinhole at a cloud's viewpoint sees its points.
struct PinholeView {
  /// Half the field of view at most, as a tangent: 63°. Depth cameras have 60° at most, and pixels
  /// farther out would be stretched more than twofold.
  static constexpr float kMaxTangent = 2.0f;
  /// Inverse depths between which points are seen [1/m]: nothing stands a tenth of a millimetre
  /// before a lens, or a million kilometres, but for points that stand for missing ones. Squares of
  /// the inverse depth keep all their digits.
  static constexpr float kMinInverseDepth = 1e-9f, kMaxInverseDepth = 1e4f;

  /// Frame V: origin at the viewpoint, z into the scene.
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  /// Every so many-th point is looked at; the pixels are so much wider.
  int stride = 1;
  /// Points that it sees, and finite ones that it does not.
  std::size_t seen = 0, unseen = 0;
  /// The tangents (u, v) of the points that it sees.
  Eigen::AlignedBox2f bounds;

  /// (u, v, w) of a point p_C [m], as in SeenPoints.
  Eigen::Vector3f operator()(const Eigen::Vector3f& p_C) const {
    const Eigen::Matrix4f& X = X_VC.matrix();
    const auto row = [&](int r) {
      return X(r, 0) * p_C.x() + X(r, 1) * p_C.y() + X(r, 2) * p_C.z() + X(r, 3);
    };
    const float w = 1.0f / row(2), u = row(0) * w, v = row(1) * w;
    // Also false for NaN. No && and ||, that would stop the compiler
    // from taking several points at once.
    const bool inside = (w > kMinInverseDepth) & (w < kMaxInverseDepth) &
                        (std::abs(u) < kMaxTangent) & (std::abs(v) < kMaxTangent);
    return {inside ? u : 0.0f, inside ? v : 0.0f, inside ? w : 0.0f};
  }

  /// Points to look at in a cloud of that size.
  std::size_t looked_at(std::size_t points) const {
    const std::size_t step = static_cast<std::size_t>(stride);
    return (points + step - 1) / step;
  }
  /// Looks at kSize points from the k-th one of them on; what is past the end counts as missing.
  QUADRILLE_EXPORT SeenPoints look(std::span<const Eigen::Vector3f> points, std::size_t k) const;
};

/// Looks at a cloud from its viewpoint: along z of the cloud's frame if all points lie there, as in
/// a camera's own frame, else to the middle of the points. Nullopt if it sees none.
QUADRILLE_EXPORT std::optional<PinholeView> look_from_viewpoint(const CloudView& cloud,
                                                                int stride = 1);

/// The same, but nullopt also if the cloud is no single view: too small, or not all ahead of its
/// viewpoint within a pinhole's field of view.
QUADRILLE_EXPORT std::optional<PinholeView> find_view(const CloudView& cloud, int stride = 1);

/// The pixels that a view fills.
struct PinholeImage {
  /// Tangents of the first pixel's near corner, and the steps from pixel to pixel along u and v.
  Eigen::Array2f corner = Eigen::Array2f::Zero(), pitch = Eigen::Array2f::Zero();
  /// Size in pixels.
  int width = 0, height = 0;
};

/// Finds pitch and phase of square pixels from the points themselves: from the steps between
/// consecutive points where they come row by row, else from their density. Nullopt if the points
/// fill no image.
QUADRILLE_EXPORT std::optional<PinholeImage> find_image(const CloudView& cloud,
                                                        const PinholeView& view);

/// Finds the pixels one by one, for a depth image: with a pitch of their own along u and v, if
/// they repeat so regularly that each point falls into a pixel of its own; else pixels so coarse
/// that the usual one holds two points. Whatever the points are, the image has max_pixels at most:
/// its pixels become coarser.
QUADRILLE_EXPORT PinholeImage find_pixels(const CloudView& cloud, const PinholeView& view,
                                          double max_pixels);

}  // namespace quadrille
