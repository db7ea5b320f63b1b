#pragma once

#include <Eigen/Core>

namespace quadrille {

/// Oriented points for a fit, in a frame where they fill about the unit ball around the origin
/// (Hartley's normalisation, which the paper asks for).
struct FitPoints {
  /// Coordinates and unit normals, one entry per point.
  Eigen::ArrayXf x, y, z, nx, ny, nz;

  explicit FitPoints(Eigen::Index size = 0)
      : x(size), y(size), z(size), nx(size), ny(size), nz(size) {}
  Eigen::Index size() const { return x.size(); }
  Eigen::Vector3d point(Eigen::Index i) const {
    return Eigen::Vector3f(x[i], y[i], z[i]).cast<double>();
  }
  Eigen::Vector3d normal(Eigen::Index i) const {
    return Eigen::Vector3f(nx[i], ny[i], nz[i]).cast<double>();
  }
};

}  // namespace quadrille
