#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "grasping/scenes.hpp"
#include "quadrille/grasping/shape.hpp"
#include "support/exact_detection.hpp"

namespace quadrille::test {

/// A quadric of random sizes and pose with the extent of what was seen of it, and points of it that
/// follow from its ten coefficients alone, not from the sizes that shapes are made of.
class ClippedSurface {
 public:
  ClippedSurface(QuadricType type, std::mt19937& random) : random_(random) {
    const auto u = [&](double lo, double hi) { return uniform(random_, lo, hi); };
    Eigen::Vector3d lo(-1, -1, -1), hi(1, 1, 1);  // no bound where the type is closed
    std::vector<Dimension> sizes;
    const auto size = [&](const char* name, double low, double high) {
      sizes.push_back({name, u(low, high), 0.0});
    };
    const auto span = [&](int axis, double from, double to) {
      lo[axis] = u(from, from + 0.4 * (to - from));
      hi[axis] = u(from + 0.6 * (to - from), to);
    };
    switch (type) {
      case QuadricType::kSphere:
        size("radius", 0.005, 0.1);
        break;
      case QuadricType::kEllipsoid:
      case QuadricType::kHyperboloidOneSheet:
      case QuadricType::kHyperboloidTwoSheets:
        for (const char* name : {"a", "b", "c"}) size(name, 0.01, 0.08);
        if (type == QuadricType::kHyperboloidOneSheet) span(2, -0.1, 0.1);
        if (type == QuadricType::kHyperboloidTwoSheets) {
          const double side = random_() % 2 ? 1.0 : -1.0, c = sizes[2].value;
          const double near = random_() % 2 ? c : u(c, c + 0.02), far = near + u(0.01, 0.08);
          lo.z() = std::min(side * near, side * far);
          hi.z() = std::max(side * near, side * far);
        }
        break;
      case QuadricType::kCylinder:
      case QuadricType::kEllipticCylinder:
        size("a", 0.005, 0.1);
        if (type == QuadricType::kEllipticCylinder) size("b", 0.005, 0.1);
        span(2, -0.15, 0.15);
        break;
      case QuadricType::kCone:
      case QuadricType::kEllipticCone:
        size("half_angle", 0.05, 1.2);
        if (type == QuadricType::kEllipticCone) size("half_angle_b", 0.05, 1.2);
        span(2, 0.0, 0.1);
        if (random_() % 2) lo.z() = 0.0;  // whole
        break;
      case QuadricType::kEllipticParaboloid:
        size("focal_a", 0.002, 0.05);
        size("focal_b", 0.002, 0.05);
        span(2, 0.0, 0.12);
        break;
      case QuadricType::kHyperbolicParaboloid:
        size("focal_a", 0.01, 0.1);
        size("focal_b", 0.01, 0.1);
        span(0, -0.1, 0.1);
        span(1, -0.1, 0.1);
        break;
      case QuadricType::kHyperbolicCylinder:
        size("a", 0.01, 0.05);
        size("b", 0.01, 0.05);
        span(1, -0.08, 0.08);
        span(2, -0.1, 0.1);
        if (random_() % 2) lo.x() = 0.01;  // one branch
        break;
      case QuadricType::kParabolicCylinder:
        size("focal", 0.005, 0.1);
        span(0, -0.1, 0.1);
        span(1, -0.1, 0.1);
        break;
      case QuadricType::kParallelPlanes:
        size("distance", 0.01, 0.1);
        span(0, -0.1, 0.1);
        span(1, -0.1, 0.1);
        break;
      case QuadricType::kIntersectingPlanes:
        size("angle", 0.1, 1.5);
        for (int axis = 0; axis < 3; ++axis) span(axis, -0.1, 0.1);
        if (random_() % 2) lo.x() = 0.0;  // one edge
        break;
      default:
        span(0, -0.2, 0.2);
        span(1, -0.2, 0.2);
    }
    detection_ = exact_detection(type, random_pose(random_), sizes, {lo, hi});
    if (random_() % 2) detection_.Q_C = detection_.Q_C.flipped();
    Q_Q_ = exact_detection(type, Eigen::Isometry3d::Identity(), sizes, {}).Q_C.matrix();
    if (type == QuadricType::kIntersectingPlanes) {
      const double half = 0.5 * sizes[0].value;
      normals_ = {{-std::sin(half), std::cos(half), 0.0}, {std::sin(half), std::cos(half), 0.0}};
    }
  }

  const Detection& detection() const { return detection_; }

  /// Points of the surface within the extent, where random lines meet it; in frame C.
  std::vector<Eigen::Vector3d> sample(int lines) {
    std::vector<Eigen::Vector3d> points;
    const Eigen::AlignedBox3d& box = detection_.extent_Q;
    const Eigen::AlignedBox3d near(box.min().cwiseMax(-0.12), box.max().cwiseMin(0.12));
    for (int n = 0; n < lines; ++n) {
      const Eigen::Vector3d p = random_point(random_, near), d = random_rotation(random_).col(0);
      for (const double t : roots(p, d)) {
        const Eigen::Vector3d x = p + t * d;
        if (box.contains(x)) points.push_back(detection_.X_CQ * x);
      }
    }
    return points;
  }

  /// A bound from above of the distance of p_C from the solid within the extent, or from the
  /// surface of a type that bounds none: along many lines.
  double distance(const Eigen::Vector3d& p_C) const {
    const Eigen::Vector3d p = detection_.X_CQ.inverse() * p_C;
    if (solid(p)) return 0.0;
    double least = std::numeric_limits<double>::infinity();
    // Straight to a flat end, as from the apex that a cone was cut off.
    const Eigen::AlignedBox3d& box = detection_.extent_Q;
    const double end = std::clamp(p.z(), box.min().z(), box.max().z());
    if (solid({p.x(), p.y(), end})) least = std::abs(end - p.z());
    for (const Eigen::Vector3d& d : directions(p)) {
      for (const double t : roots(p, d)) {
        if (std::abs(t) < least && within_ends(p + t * d)) least = std::abs(t);
      }
    }
    return least;
  }

 private:
  // Parameters of the points of p + t·d that lie on the quadric.
  std::vector<double> roots(const Eigen::Vector3d& p, const Eigen::Vector3d& d) const {
    const Eigen::Vector4d P = p.homogeneous(), D(d.x(), d.y(), d.z(), 0.0);
    const double A = D.dot(Q_Q_ * D), B = D.dot(Q_Q_ * P), C = P.dot(Q_Q_ * P);
    if (std::abs(A) < 1e-9 * std::abs(B)) return {-0.5 * C / B};
    const double square = B * B - A * C, rounding = 1e-12 * (B * B + std::abs(A * C));
    if (square < -rounding || A == 0.0) return {};
    if (square < rounding) return {-B / A};  // a coincident plane
    const double root = std::sqrt(square);
    const double q = -(B + std::copysign(root, B));
    if (q == 0.0) return {0.0};
    return {q / A, C / q};
  }

  bool bounds_solid() const {
    switch (detection_.type) {
      case QuadricType::kHyperbolicParaboloid:
      case QuadricType::kHyperbolicCylinder:
      case QuadricType::kParabolicCylinder:
        return false;
      default:
        return !is_flat(detection_.type) || detection_.type == QuadricType::kParallelPlanes;
    }
  }

  bool within_ends(const Eigen::Vector3d& p) const {
    if (!bounds_solid() || detection_.type == QuadricType::kParallelPlanes) return true;
    const double low =
        detection_.type == QuadricType::kEllipticParaboloid ? 0.0 : detection_.extent_Q.min().z();
    return p.z() >= low - 1e-9 && p.z() <= detection_.extent_Q.max().z() + 1e-9;
  }

  bool solid(const Eigen::Vector3d& p) const {
    if (!bounds_solid() || !within_ends(p)) return false;
    if (detection_.type == QuadricType::kParallelPlanes &&
        (p.head<2>().array() > detection_.extent_Q.max().head<2>().array() + 1e-9).any())
      return false;
    // f is of one sign within, the same as far along −z² for two sheets, on the axis for all else.
    const Eigen::Vector3d inner =
        Eigen::Vector3d::UnitZ() *
        (within_ends({0, 0, 0}) && !open_at_origin() ? 0.0 : detection_.extent_Q.center().z());
    const auto f = [&](const Eigen::Vector3d& x) {
      return x.homogeneous().dot(Q_Q_ * x.homogeneous());
    };
    return f(p) * f(inner) >= -1e-15;
  }

  bool open_at_origin() const {
    return detection_.type == QuadricType::kCone || detection_.type == QuadricType::kEllipticCone ||
           detection_.type == QuadricType::kEllipticParaboloid ||
           detection_.type == QuadricType::kHyperboloidTwoSheets;
  }

  std::vector<Eigen::Vector3d> directions(const Eigen::Vector3d& p) const {
    std::vector<Eigen::Vector3d> all = normals_;
    for (int axis = 0; axis < 3; ++axis) all.push_back(Eigen::Vector3d::Unit(axis));
    const Eigen::Vector3d radial = Eigen::Vector3d(p.x(), p.y(), 0.0).normalized();
    for (int k = 0; k < 64 && radial.allFinite(); ++k) {
      const double t = std::numbers::pi * k / 64;
      all.push_back(std::cos(t) * radial + std::sin(t) * Eigen::Vector3d::UnitZ());
    }
    return all;
  }

  std::mt19937& random_;
  Detection detection_;
  Eigen::Matrix4d Q_Q_;
  std::vector<Eigen::Vector3d> normals_;
};

}  // namespace quadrille::test
