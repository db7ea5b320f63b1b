#include "quadrille/detector/near_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quadrille {
namespace {

/// Bounds of a shape in its own frame [m].
Eigen::AlignedBox3d bounds_of(const SolidShape& shape) {
  const std::vector<double>& d = shape.dimensions;
  Eigen::AlignedBox3d box;
  if (shape.kind == "convex") {
    for (const Eigen::Vector3d& v : shape.vertices_S) box.extend(v);
    return box;
  }
  Eigen::Vector3d half(d[0], d[0], d[0]);
  if (shape.kind == "ellipsoid") half = {d[0], d[1], d[2]};
  if (shape.kind == "box") half = 0.5 * Eigen::Vector3d(d[0], d[1], d[2]);
  if (shape.kind == "cylinder" || shape.kind == "cone") half.z() = 0.5 * d[1];
  if (shape.kind == "capsule") half.z() = d[0] + 0.5 * d[1];
  return {-half, half};
}

/// Distance of a point from a box with its middle at the origin; 0 inside [m].
double box_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& half) {
  return (p.cwiseAbs() - half).cwiseMax(0.0).norm();
}

/// Distance of a point from the segment of this half length on the z axis [m].
double segment_distance(const Eigen::Vector3d& p, double half) {
  return std::hypot(p.head<2>().norm(), std::max(std::abs(p.z()) - half, 0.0));
}

double cylinder_distance(const Eigen::Vector3d& p, double radius, double half) {
  return std::hypot(std::max(p.head<2>().norm() - radius, 0.0),
                    std::max(std::abs(p.z()) - half, 0.0));
}

/// Distance of a point from an ellipsoid; 0 inside [m]. The nearest point x of the surface
/// satisfies p - x = t (x/a², y/b², z/c²) for the t at which x lies on the surface.
double ellipsoid_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& axes) {
  if (p.cwiseQuotient(axes).norm() <= 1.0) return 0.0;
  const Eigen::Array3d squares = axes.array().square();
  // The point of the surface is beyond it at the low end, and within at the high one.
  double low = 0.0, high = axes.maxCoeff() * p.norm();
  for (int halving = 0; halving < 60; ++halving) {
    const double t = 0.5 * (low + high);
    const bool beyond = (axes.array() * p.array() / (squares + t)).matrix().norm() > 1.0;
    (beyond ? low : high) = t;
  }
  return (p.array() * high / (squares + high)).matrix().norm();
}

/// True for a point in the cone, its side moved outward by a distance and its base down by it.
bool in_cone(const Eigen::Vector3d& p, double radius, double length, double distance) {
  if (p.z() < -0.5 * length - distance) return false;
  const double slant = std::hypot(radius, length);
  const double below_apex = 0.5 * length - p.z();
  return (p.head<2>().norm() * length - below_apex * radius) / slant <= distance &&
         below_apex >= -distance;
}

Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& vertices) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : vertices) sum += v;
  return sum / static_cast<double>(vertices.size());
}

}  // namespace

NearShape::NearShape(const SolidShape& shape, double distance)
    : shape_(shape), distance_(distance), X_SC_(shape.X_CS.inverse()) {
  Eigen::AlignedBox3d bounds = bounds_of(shape);
  bounds.min().array() -= distance;
  bounds.max().array() += distance;
  bounds_C_ = bounds.transformed(shape.X_CS);
  if (shape.kind != "convex") return;
  const Eigen::Vector3d inside = middle_of(shape.vertices_S);
  std::vector<Eigen::Vector4d> planes;
  for (std::size_t at = 0; at < shape.faces.size(); at += 1 + shape.faces[at]) {
    const Eigen::Vector3d& a = shape.vertices_S[shape.faces[at + 1]];
    const Eigen::Vector3d& b = shape.vertices_S[shape.faces[at + 2]];
    const Eigen::Vector3d& c = shape.vertices_S[shape.faces[at + 3]];
    Eigen::Vector3d n = (b - a).cross(c - a).stableNormalized();
    if (n.dot(a - inside) < 0.0) n = -n;
    planes.emplace_back(n.x(), n.y(), n.z(), n.dot(a));
  }
  normals_S_.resize(static_cast<Eigen::Index>(planes.size()), 3);
  offsets_.resize(normals_S_.rows());
  for (Eigen::Index k = 0; k < offsets_.size(); ++k) {
    normals_S_.row(k) = planes[k].head<3>().transpose();
    offsets_[k] = planes[k][3];
  }
}

bool NearShape::contains(const Eigen::Vector3d& p_C) const {
  const Eigen::Vector3d p = X_SC_ * p_C;
  const std::vector<double>& d = shape_.dimensions;
  const std::string& kind = shape_.kind;
  if (kind == "sphere") return p.norm() <= d[0] + distance_;
  if (kind == "capsule") return segment_distance(p, 0.5 * d[1]) <= d[0] + distance_;
  if (kind == "cylinder") return cylinder_distance(p, d[0], 0.5 * d[1]) <= distance_;
  if (kind == "box") return box_distance(p, 0.5 * Eigen::Vector3d(d[0], d[1], d[2])) <= distance_;
  if (kind == "cone") return in_cone(p, d[0], d[1], distance_);
  if (kind == "ellipsoid") {
    return ellipsoid_distance(p, Eigen::Vector3d(d[0], d[1], d[2])) <= distance_;
  }
  return ((normals_S_ * p).array() <= offsets_.array() + distance_).all();
}

}  // namespace quadrille
