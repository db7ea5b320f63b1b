#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string_view>

#include "fits/normalise.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/quadric_points.hpp"

namespace quadrille::test {

/// A surface given by closed forms of its points and gradients, so that a fit is not compared with
/// the library's own quadrics. Its size is about 1.
struct ExactShape {
  std::string_view kind;
  double a, b, c;

  OrientedPoint at(RandomStream& random) const {
    const auto between = [&](double low, double high) {
      return low + (high - low) * random.uniform();
    };
    const double t = between(0.0, 2.0 * M_PI), z = between(-1.0, 1.0), w = between(-1.0, 1.0);
    const double side = random.below(2) ? 1.0 : -1.0;
    const double x = std::sqrt(std::abs(w)) * std::cos(t), y = std::sqrt(std::abs(w)) * std::sin(t);
    const double rho = std::sqrt(1.0 - z * z);
    Eigen::Vector3d p, g;
    if (kind == "plane") {
      p << z, w, 0, g << 0, 0, 1;
    } else if (kind == "parallel_planes") {
      p << z, w, 0.5 * a * side, g << 0, 0, side;
    } else if (kind == "intersecting_planes") {
      // Points near the common line are left out, and such near an apex: the gradient vanishes
      // there.
      const double angle = 0.15 + a, d = between(0.05, 1.0) * (z < 0.0 ? -1.0 : 1.0);
      p << d * std::cos(angle), w, side * d * std::sin(angle);
      g << p.x() / std::pow(std::cos(angle), 2), 0, -p.z() / std::pow(std::sin(angle), 2);
    } else if (kind == "sphere" || kind == "spheroid" || kind == "ellipsoid") {
      const Eigen::Vector3d axes(a, kind == "ellipsoid" ? b : a, kind == "sphere" ? a : c);
      const Eigen::Vector3d u(rho * std::cos(t), rho * std::sin(t), z);
      p = axes.cwiseProduct(u), g = u.cwiseQuotient(axes);
    } else if (kind == "cylinder" || kind == "elliptic_cylinder") {
      const double other = kind == "cylinder" ? a : b;
      p << a * std::cos(t), other * std::sin(t), z;
      g << p.x() / (a * a), p.y() / (other * other), 0;
    } else if (kind == "cone" || kind == "double_cone" || kind == "elliptic_cone") {
      const double other = kind == "elliptic_cone" ? b : a;
      const double s = (0.15 + 0.85 * std::abs(w)) * (kind == "cone" ? 1.0 : side);
      p << a * s * std::cos(t), other * s * std::sin(t), s;
      g << p.x() / (a * a), p.y() / (other * other), -s;
    } else if (kind == "elliptic_paraboloid") {
      p << x, y, a * x * x + b * y * y, g << 2 * a * x, 2 * b * y, -1;
    } else if (kind == "hyperbolic_paraboloid") {
      p << x, y, a * x * x - b * y * y, g << 2 * a * x, -2 * b * y, -1;
    } else if (kind == "hyperboloid_one_sheet") {
      const double r = 0.5 * std::sqrt(1.0 + z * z / (c * c));
      p << a * r * std::cos(t), b * r * std::sin(t), z;
      g << 4 * p.x() / (a * a), 4 * p.y() / (b * b), -z / (c * c);
    } else if (kind == "hyperboloid_two_sheets") {
      const double h = 0.5 * c * side;
      p << x, y, h * std::sqrt(1.0 + x * x / (a * a) + y * y / (b * b));
      g << -x / (a * a), -y / (b * b), p.z() / (h * h);
    } else if (kind == "hyperbolic_cylinder") {
      const double h = 0.5 * a * side;
      p << h * std::sqrt(1.0 + z * z / (b * b)), z, w;
      g << p.x() / (h * h), -z / (b * b), 0;
    } else {  // parabolic_cylinder
      p << z, w, a * z * z, g << 2 * a * z, 0, -1;
    }
    return {p, g.normalized()};
  }
};

inline ExactShape random_exact(std::string_view kind, RandomStream& random) {
  const auto proportion = [&] { return std::pow(0.3, random.uniform()); };
  const double a = proportion(), b = proportion(), c = proportion();
  return {kind, a, b, c};
}

/// A basis of a random surface of a kind, from 1 mm to 30 m large, up to 5 m from the origin, seen
/// from either side, and further points of the surface.
struct ExactBasis {
  OrientedPointsd points, further;
  double size;

  ExactBasis(std::string_view kind, int count, RandomStream& random)
      : points(count), further(20), size(0.001 * std::pow(3e4, random.uniform())) {
    const ExactShape shape = random_exact(kind, random);
    const Eigen::Isometry3d X = random_pose(random, 3.0);
    const double side = random.below(2) ? 1.0 : -1.0;
    for (OrientedPointsd* set : {&points, &further}) {
      for (Eigen::Index i = 0; i < set->size(); ++i) {
        const OrientedPoint p = shape.at(random);
        set->points.col(i) = X * Eigen::Vector3d(size * p.x);
        set->normals.col(i) = side * (X.linear() * p.n).normalized();
      }
    }
  }

  /// True if the further points lie on the quadric to a millionth of the size, with their normals
  /// on the side of its gradient.
  bool is_of(const Quadric& Q) const {
    for (Eigen::Index i = 0; i < further.size(); ++i) {
      const Eigen::Vector3d x = further.points.col(i);
      const bool near = std::abs(Q.distance(x)) <= 1e-6 * size;
      if (!near || !(Q.gradient(x).dot(further.normals.col(i)) > 0.0)) return false;
    }
    return true;
  }
};

/// How often a fit was right, refused, or wrong.
struct ExactTally {
  int right = 0, refused = 0, wrong = 0;

  template <typename Fit>
  ExactTally(const Fit& fit, std::string_view kind, int points, int trials, RandomStream& random) {
    for (int trial = 0; trial < trials; ++trial) {
      const ExactBasis basis(kind, points, random);
      const auto Q = fit(basis.points);
      ++(!Q ? refused : basis.is_of(*Q) ? right : wrong);
    }
  }
  double share_right() const { return static_cast<double>(right) / (right + refused + wrong); }
};

}  // namespace quadrille::test
