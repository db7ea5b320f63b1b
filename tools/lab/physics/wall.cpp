#include "lab/physics/wall.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

// Cuts a body, given by the distance `within`, to the slab z_0 ≤ z ≤ z_1, and returns the distance
// to the rest.
WallDistance slab(double z, double z_0, double z_1, const WallDistance& within) {
  WallDistance result = within;
  if (z - z_1 > result.distance) result = {z - z_1, Vector3d::UnitZ()};
  if (z_0 - z > result.distance) result = {z_0 - z, -Vector3d::UnitZ()};
  return result;
}

}  // namespace

WallDistance wall_distance(const TrueBody& body, const Vector3d& p_S) {
  const double z = std::clamp(p_S.z(), body.z_min(), body.z_max());
  const double s = std::max(body.scale(z), 1e-6), half = 0.5 * body.wall;
  const double u = p_S.x() / body.a, v = p_S.y() / body.b, rho = std::max(std::hypot(u, v), 1e-9);
  // This is the gradient of ρ − s(z).
  const Vector3d gradient(u / (body.a * rho), v / (body.b * rho),
                          -(0.5 * body.p[1] + body.p[2] * z) / s);
  const double offset = (rho - s) / gradient.norm() - body.wall_at;
  const Vector3d outward = gradient.normalized();
  const WallDistance shell{std::abs(offset) - half, offset < 0.0 ? Vector3d(-outward) : outward};
  const WallDistance filled{offset - half, outward};
  const double z_0 = body.z_min(), z_1 = body.z_max();
  WallDistance best = slab(p_S.z(), z_0, z_1, shell);
  const auto add_floor = [&](double from, double to) {
    const WallDistance floor = slab(p_S.z(), from, to, filled);
    if (floor.distance < best.distance) best = floor;
  };
  if (!body.open_low) add_floor(z_0, z_0 + body.wall);
  if (!body.open_high) add_floor(z_1 - body.wall, z_1);
  return best;
}

}  // namespace quadrille::physics
