#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "base/vector_clones.hpp"
#include "quadrille/detector/pinhole.hpp"

namespace quadrille {

/// Looks at points as PinholeView::look() does. It is compiled into each caller, so that a caller
/// with vector clones gets vectors here too, and no calls in its loop over the points.
QUADRILLE_INTO_CLONES SeenPoints look_at(const PinholeView& view,
                                         std::span<const Eigen::Vector3f> points, std::size_t k) {
  constexpr int kSize = SeenPoints::kSize;
  const std::size_t step = static_cast<std::size_t>(view.stride), first = k * step;
  std::array<Eigen::Vector3f, kSize> some;
  const float* p = nullptr;
  if (step == 1 && first + kSize <= points.size()) {
    p = points[first].data();
  } else {
    for (int i = 0; i < kSize; ++i) {
      const std::size_t at = first + static_cast<std::size_t>(i) * step;
      if (at < points.size()) {
        some[i] = points[at];
      } else {
        some[i].setConstant(std::numeric_limits<float>::quiet_NaN());
      }
    }
    p = some[0].data();
  }
  // The compiler makes vectors only of plain arrays that nothing else may point to, so this is
  // PinholeView::operator() written out.
  const Eigen::Matrix4f X = view.X_VC.matrix();
  constexpr std::ptrdiff_t kStep = 3;
  std::array<float, kSize> x, y, z;
  for (int i = 0; i < kSize; ++i)
    x[i] = p[kStep * i], y[i] = p[kStep * i + 1], z[i] = p[kStep * i + 2];
  SeenPoints seen;
  for (int i = 0; i < kSize; ++i) {
    const float w = 1.0f / (X(2, 0) * x[i] + X(2, 1) * y[i] + X(2, 2) * z[i] + X(2, 3));
    const float u = (X(0, 0) * x[i] + X(0, 1) * y[i] + X(0, 2) * z[i] + X(0, 3)) * w;
    const float v = (X(1, 0) * x[i] + X(1, 1) * y[i] + X(1, 2) * z[i] + X(1, 3)) * w;
    const bool inside = (w > PinholeView::kMinInverseDepth) & (w < PinholeView::kMaxInverseDepth) &
                        (std::abs(u) < PinholeView::kMaxTangent) &
                        (std::abs(v) < PinholeView::kMaxTangent);
    seen.u[i] = inside ? u : 0.0f, seen.v[i] = inside ? v : 0.0f, seen.w[i] = inside ? w : 0.0f;
  }
  return seen;
}

}  // namespace quadrille
