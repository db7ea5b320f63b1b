#include "fit/closed_form/special_revolutions.hpp"

#include <cmath>

namespace quadrille {

std::optional<PosedQuadric> initial_paraboloid(const PosedQuadric& revolution) {
  PosedQuadric paraboloid = revolution;
  const double i = revolution.D(2, 3), j = revolution.D(3, 3);
  if (std::abs(i) < 1e-6) return std::nullopt;
  // The vertex of x² + y² + 2 i z + j = 0 is at z = -j / 2i.
  paraboloid.D(2, 2) = paraboloid.D(3, 3) = 0.0;
  paraboloid.X = revolution.X * Eigen::Translation3d(0, 0, -0.5 * j / i);
  if (std::abs(0.5 * j / i) > 1e3) return std::nullopt;
  return paraboloid;
}

std::optional<PosedQuadric> tangent_cone(const PosedQuadric& revolution) {
  // Near z = 0, ρ² = −j − 2 i z − c z² has radius r and slope dρ/dz = −i / r.
  const double i = revolution.D(2, 3), j = revolution.D(3, 3);
  if (!(j < 0) || std::abs(i) < 1e-9) return std::nullopt;
  const double r = std::sqrt(-j), slope = -i / r;
  if (std::abs(r / slope) > 1e3) return std::nullopt;
  PosedQuadric cone;
  cone.X = revolution.X * Eigen::Translation3d(0, 0, -r / slope);
  cone.D.diagonal() << 1, 1, -slope * slope, 0;
  return cone;
}

std::optional<PosedQuadric> tangent_cylinder(const PosedQuadric& revolution) {
  const double j = revolution.D(3, 3);
  if (!(j < 0)) return std::nullopt;
  PosedQuadric cylinder = revolution;
  cylinder.D = Eigen::Vector4d(1, 1, 0, j).asDiagonal();
  return cylinder;
}

}  // namespace quadrille
