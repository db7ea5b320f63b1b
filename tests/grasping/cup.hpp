#pragma once

#include "grasping/scenes.hpp"

namespace quadrille::test {

/// A cup that stands on the table, its wall and bottom of one thickness; with a lid if closed.
struct Cup {
  double radius = 0.045, height = 0.08, wall = 0.004;
  bool closed = false;

  /// Where a ray from p along d (frame of the table) first meets it, infinite if nowhere.
  double hit(const Eigen::Vector3d& p, const Eigen::Vector3d& d) const {
    double first = std::numeric_limits<double>::infinity();
    const auto take = [&](double t, double r_min, double r_max, double z_min, double z_max) {
      const Eigen::Vector3d x = p + t * d;
      const double r = x.head<2>().norm(), slack = 1e-9;
      if (t > 0.0 && r >= r_min - slack && r <= r_max + slack && x.z() >= z_min - slack &&
          x.z() <= z_max + slack) {
        first = std::min(first, t);
      }
    };
    const double inner = radius - wall;
    for (const double r : {radius, inner}) {
      const double a = d.head<2>().squaredNorm(), b = p.head<2>().dot(d.head<2>());
      const double D = b * b - a * (p.head<2>().squaredNorm() - r * r);
      if (D < 0.0) continue;
      for (const double sign : {-1.0, 1.0}) take((-b + sign * std::sqrt(D)) / a, r, r, 0.0, height);
    }
    take((wall - p.z()) / d.z(), 0.0, inner, wall, wall);
    take((height - p.z()) / d.z(), closed ? 0.0 : inner, radius, height, height);
    return first;
  }

  /// True if p (frame of the table) lies in its wall or bottom.
  bool holds(const Eigen::Vector3d& p) const {
    const double r = p.head<2>().norm();
    return p.z() > 0.0 && p.z() < height && r < radius &&
           (closed || r > radius - wall || p.z() < wall);
  }
};

inline PointCloud render(const Cup& cup) {
  const Eigen::Isometry3d X_TC = table_detection().X_CQ.inverse();
  PointCloud cloud;
  cloud.width = kWidth;
  cloud.height = kHeight;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray = pixel_ray(u, v);
      const double t =
          std::min(ray_depth(ray, {}), cup.hit(X_TC.translation(), X_TC.linear() * ray));
      cloud.points.push_back(std::isfinite(t) ? Eigen::Vector3f((t * ray).cast<float>())
                                              : Eigen::Vector3f::Constant(std::nanf("")));
    }
  }
  cloud.read = cloud.points.size();
  return cloud;
}

/// Its outer wall as a detection, or its inner one, with the gradient to the side that is seen.
inline Detection wall_detection(const Cup& cup, bool inner) {
  Eigen::Isometry3d X_CQ = table_detection().X_CQ;
  X_CQ.translation() = X_CQ * Eigen::Vector3d(0.0, 0.0, 0.5 * cup.height);
  const double r = inner ? cup.radius - cup.wall : cup.radius;
  Detection d = cylinder_detection(X_CQ, r, cup.height);
  Eigen::Matrix4d Q = Eigen::Vector4d(1.0, 1.0, 0.0, -r * r).asDiagonal();
  d.Q_C = Quadric(Eigen::Matrix4d(inner ? -Q : Q)).transformed(X_CQ);
  return d;
}

}  // namespace quadrille::test
