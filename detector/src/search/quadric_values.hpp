#pragma once

#include <Eigen/Core>

#include "fit/fit_points.hpp"

namespace quadrille {

/// A quadric f = xᵀQx at many points, in single precision: f and half its gradient, of which
/// distances and angles are made.
struct QuadricValues {
  Eigen::ArrayXf gx, gy, gz, f;

  QuadricValues(const Eigen::Matrix4f& Q, const FitPoints& p)
      : gx(Q(0, 0) * p.x + Q(0, 1) * p.y + Q(0, 2) * p.z + Q(0, 3)),
        gy(Q(0, 1) * p.x + Q(1, 1) * p.y + Q(1, 2) * p.z + Q(1, 3)),
        gz(Q(0, 2) * p.x + Q(1, 2) * p.y + Q(2, 2) * p.z + Q(2, 3)),
        f(gx * p.x + gy * p.y + gz * p.z + Q(0, 3) * p.x + Q(1, 3) * p.y + Q(2, 3) * p.z +
          Q(3, 3)) {}
};

}  // namespace quadrille
