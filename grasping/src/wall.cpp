#include <fcl/geometry/shape/convex.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadrille/grasping/rim.hpp"

namespace quadrille {

namespace {

constexpr int kSectors = 24;
constexpr int kMostSlices = 8;
// Height of a slice: the sagitta of a bowl of 70 mm over it is 0.2 mm [m].
constexpr double kSlice = 0.01;

// Corners 0 to 3 at the lower height, 4 to 7 at the upper; of each, inner then outer, at one angle
// then at the other.
CollisionShape block(const std::vector<Eigen::Vector3d>& corners, const Eigen::Isometry3d& X_CQ) {
  CollisionShape shape;
  shape.kind = "convex";
  shape.X_CS = X_CQ;
  shape.vertices_S = corners;
  constexpr int kFaces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  for (const auto& face : kFaces)
    shape.faces.insert(shape.faces.end(), {3, face[0], face[1], face[2]});
  shape.geometry = std::make_shared<fcl::Convexd>(
      std::make_shared<const std::vector<Eigen::Vector3d>>(shape.vertices_S), 12,
      std::make_shared<const std::vector<int>>(shape.faces));
  shape.geometry->computeLocalAABB();
  return shape;
}

// A cell of the wall between two angles and two heights.
struct Cell {
  double angle0, angle1, z0, z1;

  double angle(double u) const { return (1.0 - u) * angle0 + u * angle1; }
  double z(double v) const { return (1.0 - v) * z0 + v * z1; }
};

Eigen::Vector3d wall_point(const Shell& shell, double angle, double z, double off) {
  return shell.point_Q(angle, z) + off * shell.normal_Q(angle, z);
}

// How far the surface at `off` lies beyond the plane through its corners on that side, along the
// normal of the cell's middle; side +1 outward, −1 inward.
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

// The corners of the cell, moved out by the sagitta of either side, over the least cosine between
// the normals of corners and middle that cells of 15° have.
std::vector<Eigen::Vector3d> corners(const Shell& shell, const Cell& cell) {
  constexpr double kCosine = 0.95;
  const double low = shell.inner() - sagitta(shell, cell, shell.inner(), -1.0) / kCosine;
  const double high = shell.outer() + sagitta(shell, cell, shell.outer(), 1.0) / kCosine;
  std::vector<Eigen::Vector3d> points;
  for (const double z : {cell.z0, cell.z1}) {
    for (const double angle : {cell.angle0, cell.angle1}) {
      for (const double off : {low, high}) points.push_back(wall_point(shell, angle, z, off));
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
      straight ? 1 : std::clamp(static_cast<int>(std::ceil(height / kSlice)), 1, kMostSlices);
  const double turn = 2.0 * std::numbers::pi / kSectors;
  std::vector<CollisionShape> pieces;
  for (int i = 0; i < slices; ++i) {
    const double z0 = body.z_min + height * i / slices, z1 = body.z_min + height * (i + 1) / slices;
    for (int k = 0; k < kSectors; ++k) {
      pieces.push_back(block(corners(shell, {k * turn, (k + 1) * turn, z0, z1}), body.X_CQ));
    }
  }
  return pieces;
}

}  // namespace quadrille
