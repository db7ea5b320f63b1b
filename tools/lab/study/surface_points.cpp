#include "lab/study/surface_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille::study {
namespace {

using Eigen::Vector3d;
using physics::TrueBody;

int steps_over(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

void add(const TrueBody& body, const Vector3d& p_S, const Vector3d& n_S, SurfacePoints* points) {
  points->p_C.push_back(body.X_CS * p_S);
  points->n_C.push_back(body.X_CS.linear() * n_S);
}

void add_ring(const TrueBody& body, double z, double spacing, SurfacePoints* points) {
  const double girth = 2.0 * std::numbers::pi * std::max(body.a, body.b) * body.scale(z);
  const int count = std::max(6, steps_over(girth, spacing));
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    add(body, body.point_S(angle, z), body.normal_S(angle, z), points);
  }
}

void add_cap(const TrueBody& body, double z, double side, double spacing, SurfacePoints* points) {
  const double reach = std::max(body.a, body.b) * body.scale(z);
  const int rings = steps_over(reach, spacing);
  for (int ring = 0; ring < rings; ++ring) {
    const double share = static_cast<double>(ring) / rings;
    const int count = steps_over(2.0 * std::numbers::pi * share * reach, spacing);
    for (int k = 0; k < count; ++k) {
      Vector3d p_S = body.point_S(2.0 * std::numbers::pi * k / count, z);
      p_S.head<2>() *= share;
      add(body, p_S, side * Vector3d::UnitZ(), points);
    }
  }
}

/// Adds rings at equal distances along the meridian, which runs at a right angle to the axis near
/// the poles.
void add_mantle(const TrueBody& body, double spacing, SurfacePoints* points) {
  constexpr int kFine = 40;
  const double height = body.z_max() - body.z_min();
  const int steps = kFine * steps_over(height, spacing);
  const double radius = std::max(body.a, body.b);
  double since = spacing, last = body.z_min();
  for (int k = 0; k <= steps; ++k) {
    const double z = body.z_min() + height * k / steps;
    since += std::hypot(z - last, radius * (body.scale(z) - body.scale(last)));
    last = z;
    if (since < spacing && k < steps) continue;
    since = 0.0;
    // The normal may not exist where the body ends in a point.
    if (body.scale(z) > 0.0) add_ring(body, z, spacing, points);
  }
}

void add_face(const TrueBody& body, int axis, double side, double spacing, SurfacePoints* points) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Vector3d size = body.box_S.sizes();
  const int columns = steps_over(size[u], spacing), rows = steps_over(size[v], spacing);
  for (int k = 0; k < (columns + 1) * (rows + 1); ++k) {
    Vector3d p_S = side > 0.0 ? body.box_S.max() : body.box_S.min();
    const int column = k % (columns + 1), row = k / (columns + 1);
    p_S[u] = body.box_S.min()[u] + size[u] * column / columns;
    p_S[v] = body.box_S.min()[v] + size[v] * row / rows;
    add(body, p_S, side * Vector3d::Unit(axis), points);
  }
}

}  // namespace

SurfacePoints surface_points(const TrueBody& body, double spacing) {
  SurfacePoints points;
  if (body.is_box) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) add_face(body, axis, side, spacing, &points);
    }
    return points;
  }
  add_mantle(body, spacing, &points);
  if (!body.open_low) add_cap(body, body.z_min(), -1.0, spacing, &points);
  if (!body.open_high) add_cap(body, body.z_max(), 1.0, spacing, &points);
  return points;
}

}  // namespace quadrille::study
