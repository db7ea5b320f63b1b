#pragma once

#include <Eigen/Core>
#include <optional>

namespace quadrille {

/// Sums over offsets from a nearby point, for a plane by principal components. It works in single
/// precision and is solved in closed form, since one is needed for each sample; PlaneSums serves
/// whole regions.
struct PlaneMoments {
  float n = 0;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  /// Sums of xx, yy, zz, and of xy, yz, zx.
  Eigen::Array3f squares = Eigen::Array3f::Zero(), products = Eigen::Array3f::Zero();

  void add(const Eigen::Vector3f& d) {
    n += 1;
    sum += d;
    squares += d.array().square();
    products += d.array() * Eigen::Array3f(d.y(), d.z(), d.x());
  }
  /// The mean of the offsets, relative to their reference point, and the unit direction of least
  /// spread.
  struct Plane {
    Eigen::Vector3f mean, normal;
  };
  /// Returns the plane; nullopt if the points are too few, lie on a line, or spread equally in all
  /// directions.
  std::optional<Plane> solve() const;
};

}  // namespace quadrille
