#pragma once

#include <Eigen/Core>

#include "fit/oriented_points.hpp"

namespace quadrille {

/// The coefficients of a quadric f = xᵀQx, where x = (x y z 1), in one precision.
template <typename Scalar>
struct Coefficients {
  Scalar xx, yy, zz, xy, xz, yz, x, y, z, one;

  explicit Coefficients(const Eigen::Matrix4d& Q)
      : xx(static_cast<Scalar>(Q(0, 0))),
        yy(static_cast<Scalar>(Q(1, 1))),
        zz(static_cast<Scalar>(Q(2, 2))),
        xy(static_cast<Scalar>(Q(0, 1))),
        xz(static_cast<Scalar>(Q(0, 2))),
        yz(static_cast<Scalar>(Q(1, 2))),
        x(static_cast<Scalar>(Q(0, 3))),
        y(static_cast<Scalar>(Q(1, 3))),
        z(static_cast<Scalar>(Q(2, 3))),
        one(static_cast<Scalar>(Q(3, 3))) {}
};

/// Half of ∇f, and f.
template <typename Scalar>
struct HalfGradient {
  Scalar x, y, z, f;
};

template <typename Scalar>
inline HalfGradient<Scalar> half_gradient(const Coefficients<Scalar>& q, Scalar x, Scalar y,
                                          Scalar z) {
  const Scalar gx = q.xx * x + q.xy * y + q.xz * z + q.x;
  const Scalar gy = q.xy * x + q.yy * y + q.yz * z + q.y;
  const Scalar gz = q.xz * x + q.yz * y + q.zz * z + q.z;
  return {gx, gy, gz, gx * x + gy * y + gz * z + q.x * x + q.y * y + q.z * z + q.one};
}

/// Half gradients and values at many points.
class HalfGradients {
 public:
  HalfGradients(const OrientedPointsf& points, const Eigen::Matrix4d& Q);

  OrientedPointsf::Coordinates x() const { return row(0); }
  OrientedPointsf::Coordinates y() const { return row(1); }
  OrientedPointsf::Coordinates z() const { return row(2); }
  OrientedPointsf::Coordinates f() const { return row(3); }

 private:
  OrientedPointsf::Coordinates row(Eigen::Index k) const {
    return OrientedPointsf::Coordinates(rows_.data() + k * rows_.cols(), rows_.cols());
  }

  Eigen::Matrix<float, 4, Eigen::Dynamic, Eigen::RowMajor> rows_;
};

}  // namespace quadrille
