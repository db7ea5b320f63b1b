#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Some points as a pinhole sees them: tangents u = x/z and v = y/z, and inverse depth w = 1/z
/// [1/m]. All are 0 for a point that is missing or outside the field of view.
struct SeenPoints {
  static constexpr int kSize = 16;
  std::array<float, kSize> u, v, w;
};

/// How a pinhole at a cloud's viewpoint sees its points.
struct PinholeView {
  /// Widest field of view that one image can hold, as a tangent.
  static constexpr float kWidestTangent = 2.0f;

  /// Frame V: origin at the viewpoint, z into the scene.
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  /// Every so many-th point is looked at; the pixels are so much wider.
  int stride = 1;
  /// Points that it sees, and the least and greatest tangents among them.
  std::size_t seen = 0;
  Eigen::Array2f low = Eigen::Array2f::Zero(), high = Eigen::Array2f::Zero();

  /// (u, v, w) of a point p_C [m], as in SeenPoints.
  Eigen::Vector3f operator()(const Eigen::Vector3f& p_C) const {
    const Eigen::Matrix4f& X = X_VC.matrix();
    const auto row = [&](int r) {
      return X(r, 0) * p_C.x() + X(r, 1) * p_C.y() + X(r, 2) * p_C.z() + X(r, 3);
    };
    const float w = 1.0f / row(2), u = row(0) * w, v = row(1) * w;
    // Also false for NaN and for what is infinitely far. No && and ||, that would stop the compiler
    // from taking several points at once.
    const bool inside =
        (w > 0.0f) & (w < 1e4f) & (std::abs(u) < kWidestTangent) & (std::abs(v) < kWidestTangent);
    return {inside ? u : 0.0f, inside ? v : 0.0f, inside ? w : 0.0f};
  }

  /// Points to look at in a cloud of that size.
  std::size_t looked_at(std::size_t points) const {
    const std::size_t step = static_cast<std::size_t>(stride);
    return (points + step - 1) / step;
  }
  /// Looks at kSize points from the k-th one of them on; what is past the end counts as missing.
  SeenPoints look(const std::vector<Eigen::Vector3f>& points, std::size_t k) const;
};

/// Looks at a cloud from its viewpoint; nullopt if the cloud is too small or does not lie ahead of
/// its viewpoint within a pinhole's field of view.
std::optional<PinholeView> find_view(const PointCloud& cloud, int stride = 1);

/// The image that a view fills.
struct PinholeImage {
  /// Tangents of the first pixel's near corner, and the step from pixel to pixel.
  float u0 = 0, v0 = 0, pitch = 0;
  /// Size in pixels.
  int width = 0, height = 0;
};

/// Finds pitch and phase of the pixels from the points themselves: from the steps between
/// consecutive points where they come row by row, else from their density. Nullopt if the points
/// fill no image.
std::optional<PinholeImage> find_image(const PointCloud& cloud, const PinholeView& view);

}  // namespace quadrille
