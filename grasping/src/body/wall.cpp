#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "body/polyhedron.hpp"
#include "body/shell.hpp"

namespace quadrille {
namespace {

// Sectors of 15°: over one, a wall of radius 50 mm has a sagitta of 0.4 mm. Each of them, in each
// slice, is a convex shape that hands are checked against, so the slices of high walls are few.
constexpr int kSectors = 24;
constexpr int kMaxSlices = 8;
// Height of a slice [m]: over it, a bowl of radius 70 mm has a sagitta of 0.2 mm.
constexpr double kSliceHeight = 0.01;

/// A cell of the wall between two angles and two heights.
struct Cell {
  double angle0, angle1, z0, z1;

  double angle(double u) const { return (1.0 - u) * angle0 + u * angle1; }
  double z(double v) const { return (1.0 - v) * z0 + v * z1; }
};

Eigen::Vector3d wall_point(const Shell& shell, double angle, double z, double off) {
  return shell.point_Q(angle, z) + off * shell.normal_Q(angle, z);
}

/// Returns how far the surface at offset `off` lies beyond the plane through its corners, along the
/// normal at the cell's middle; side is +1 for outward, −1 for inward.
double sagitta(const Shell& shell, const Cell& cell, double off, double side) {
  const Eigen::Vector3d n = side * shell.normal_Q(cell.angle(0.5), cell.z(0.5));
  constexpr int kSteps = 4;
  double farthest = -1e9, nearest_corner = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double u = i / double{kSteps}, v = j / double{kSteps};
      const double h = n.dot(wall_point(shell, cell.angle(u), cell.z(v), off));
      farthest = std::max(farthest, h);
      if (i % kSteps == 0 && j % kSteps == 0) nearest_corner = std::min(nearest_corner, h);
    }
  }
  return std::max(0.0, farthest - nearest_corner);
}

/// Returns the corners of the cell, moved outward on either side by the sagitta divided by the
/// least cosine between the normals at the corners and at the middle of a 15° cell.
std::array<Eigen::Vector3d, 8> corners(const Shell& shell, const Cell& cell) {
  constexpr double kMinCosine = 0.95;
  const double low = shell.inner() - sagitta(shell, cell, shell.inner(), -1.0) / kMinCosine;
  const double high = shell.outer() + sagitta(shell, cell, shell.outer(), 1.0) / kMinCosine;
  std::array<Eigen::Vector3d, 8> points;
  std::size_t n = 0;
  for (const double z : {cell.z0, cell.z1}) {
    for (const double angle : {cell.angle0, cell.angle1}) {
      for (const double off : {low, high}) points[n++] = wall_point(shell, angle, z, off);
    }
  }
  return points;
}

}  // namespace

std::vector<CollisionShape> make_wall(const Shell& shell) {
  const Body& body = shell.body;
  const double height = body.z_max - body.z_min;
  const bool straight =
      body.profile == Body::Profile::kConstant || body.profile == Body::Profile::kLinear;
  const int slices =
      straight ? 1 : std::clamp(static_cast<int>(std::ceil(height / kSliceHeight)), 1, kMaxSlices);
  const double turn = 2.0 * std::numbers::pi / kSectors;
  std::vector<CollisionShape> pieces;
  for (int i = 0; i < slices; ++i) {
    const double z0 = body.z_min + height * i / slices, z1 = body.z_min + height * (i + 1) / slices;
    for (int k = 0; k < kSectors; ++k) {
      pieces.push_back(make_block(corners(shell, {k * turn, (k + 1) * turn, z0, z1}), body.X_CQ));
    }
  }
  return pieces;
}

}  // namespace quadrille
