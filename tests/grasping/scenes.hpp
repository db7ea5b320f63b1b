#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::test {

/// A sphere in frame C.
struct Ball {
  Eigen::Vector3d p_C;
  double radius;
};

/// The table that all scenes share: seen from above at 45°, 0.8 m before the camera.
inline Detection table_detection(int id = 100) {
  Detection d;
  d.id = id;
  d.type = QuadricType::kPlane;
  const Eigen::Vector3d n = Eigen::Vector3d(0, -1, -1).normalized();
  d.X_CQ.linear() << Eigen::Vector3d::UnitX(), n.cross(Eigen::Vector3d::UnitX()), n;
  d.X_CQ.translation() = Eigen::Vector3d(0, 0, 0.8);
  d.extent_Q = {Eigen::Vector3d(-0.4, -0.3, 0.0), Eigen::Vector3d(0.4, 0.3, 0.0)};
  d.dimensions = {{"width", 0.8, 0.0}, {"height", 0.6, 0.0}};
  d.score = 1.0;
  return d;
}

inline Detection sphere_detection(const Ball& ball, int id = 1) {
  Detection d;
  d.id = id;
  d.type = QuadricType::kSphere;
  const Eigen::Vector4d squares(1, 1, 1, -ball.radius * ball.radius);
  d.X_CQ.translation() = ball.p_C;
  d.Q_C = Quadric(Eigen::Matrix4d(squares.asDiagonal())).transformed(d.X_CQ).normalized();
  d.dimensions = {{"radius", ball.radius, 0.0}};
  const Eigen::Vector3d r = Eigen::Vector3d::Constant(ball.radius);
  d.extent_Q = {-r, r};
  d.score = 1.0;
  return d;
}

inline Detection cylinder_detection(const Eigen::Isometry3d& X_CQ, double radius, double length,
                                    int id = 1) {
  Detection d;
  d.id = id;
  d.type = QuadricType::kCylinder;
  d.X_CQ = X_CQ;
  d.dimensions = {{"radius", radius, 0.0}, {"length", length, 0.0}};
  const Eigen::Vector3d half(radius, radius, 0.5 * length);
  d.extent_Q = {-half, half};
  d.score = 1.0;
  return d;
}

/// A ball that rests on the table, its foot at (x, y) of the table's frame.
inline Ball ball_on_table(double x, double y, double radius) {
  return {table_detection().X_CQ * Eigen::Vector3d(x, y, radius), radius};
}

/// Depth along the ray of unit depth, infinite where it meets nothing.
inline double ray_depth(const Eigen::Vector3d& ray, const std::vector<Ball>& balls) {
  const Detection table = table_detection();
  const Eigen::Vector3d n = table.X_CQ.linear().col(2);
  double depth = std::numeric_limits<double>::infinity();
  const double t = n.dot(table.X_CQ.translation()) / n.dot(ray);
  if (t > 0.0 &&
      table.extent_Q.contains(Eigen::Vector3d((table.X_CQ.inverse() * Eigen::Vector3d(t * ray))
                                                  .cwiseProduct(Eigen::Vector3d(1, 1, 0))))) {
    depth = t;
  }
  for (const Ball& ball : balls) {
    const double a = ray.squaredNorm(), b = ray.dot(ball.p_C);
    const double c = ball.p_C.squaredNorm() - ball.radius * ball.radius;
    const double D = b * b - a * c;
    if (D > 0.0 && b > std::sqrt(D)) depth = std::min(depth, (b - std::sqrt(D)) / a);
  }
  return depth;
}

constexpr int kWidth = 320, kHeight = 240;
constexpr double kFocal = 262.5;

inline Eigen::Vector3d pixel_ray(int u, int v) {
  return {(u - 0.5 * (kWidth - 1)) / kFocal, (v - 0.5 * (kHeight - 1)) / kFocal, 1.0};
}

/// The table with balls as an organised, noiseless cloud of a camera at the origin.
inline PointCloud render(const std::vector<Ball>& balls) {
  PointCloud cloud;
  cloud.width = kWidth;
  cloud.height = kHeight;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray = pixel_ray(u, v);
      const double depth = ray_depth(ray, balls);
      cloud.points.push_back(std::isfinite(depth) ? Eigen::Vector3f((depth * ray).cast<float>())
                                                  : Eigen::Vector3f::Constant(std::nanf("")));
    }
  }
  cloud.read = cloud.points.size();
  return cloud;
}

/// Uniform in [lo, hi) from raw generator bits, alike on all platforms.
inline double uniform(std::mt19937& random, double lo, double hi) {
  return lo + (hi - lo) * (random() / 4294967296.0);
}

inline Eigen::Vector3d random_point(std::mt19937& random, const Eigen::AlignedBox3d& box) {
  Eigen::Vector3d p;
  for (int i = 0; i < 3; ++i) p[i] = uniform(random, box.min()[i], box.max()[i]);
  return p;
}

inline Eigen::Matrix3d random_rotation(std::mt19937& random) {
  const Eigen::AlignedBox3d unit(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const Eigen::Vector3d axis = random_point(random, unit).normalized();
  return Eigen::AngleAxisd(uniform(random, 0.0, 3.1), axis).toRotationMatrix();
}

inline Eigen::Isometry3d random_pose(std::mt19937& random) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = random_rotation(random);
  X.translation() =
      random_point(random, {Eigen::Vector3d(-0.3, -0.3, 0.5), Eigen::Vector3d(0.3, 0.3, 1.0)});
  return X;
}

/// One detection of each type that bounds a solid, in its own canonical frame.
inline std::vector<Detection> solid_detections() {
  const auto make = [](QuadricType type, std::vector<double> sizes, Eigen::Vector3d lo,
                       Eigen::Vector3d hi) {
    Detection d;
    d.id = static_cast<int>(type) + 1;
    d.type = type;
    for (const double size : sizes) d.dimensions.push_back({"size", size, 0.0});
    d.extent_Q = {lo, hi};
    d.score = 1.0;
    return d;
  };
  return {
      make(QuadricType::kSphere, {0.03}, {-0.03, -0.03, -0.03}, {0.03, 0.03, 0.03}),
      make(QuadricType::kEllipsoid, {0.04, 0.03, 0.02}, {-0.04, -0.03, -0.02}, {0.04, 0.03, 0.02}),
      make(QuadricType::kCylinder, {0.03, 0.1}, {-0.03, -0.03, -0.05}, {0.03, 0.03, 0.05}),
      make(QuadricType::kEllipticCylinder, {0.035, 0.025, 0.1}, {-0.035, -0.025, -0.05},
           {0.035, 0.025, 0.05}),
      make(QuadricType::kCone, {0.3}, {-0.03, -0.03, 0.03}, {0.03, 0.03, 0.1}),
      make(QuadricType::kCone, {0.3}, {-0.03, -0.03, -0.1}, {0.03, 0.03, 0.0}),
      make(QuadricType::kEllipticCone, {0.3, 0.2}, {-0.03, -0.03, 0.02}, {0.03, 0.03, 0.1}),
      make(QuadricType::kEllipticParaboloid, {0.004, 0.003}, {-0.025, -0.022, 0.0},
           {0.025, 0.022, 0.04}),
      make(QuadricType::kHyperboloidOneSheet, {0.025, 0.02, 0.04}, {-0.035, -0.03, -0.04},
           {0.035, 0.03, 0.04}),
      make(QuadricType::kHyperboloidTwoSheets, {0.009, 0.008, 0.03}, {-0.03, -0.03, 0.03},
           {0.03, 0.03, 0.09}),
      make(QuadricType::kHyperboloidTwoSheets, {0.01, 0.01, 0.025}, {-0.03, -0.03, -0.09},
           {0.03, 0.03, -0.04}),
      make(QuadricType::kParallelPlanes, {0.05}, {-0.03, -0.04, -0.025}, {0.03, 0.04, 0.025}),
  };
}

/// Points all over a ball.
inline std::vector<Eigen::Vector3d> skin(const Ball& ball) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 2000; ++i) {
    const double z = 1.0 - (i + 0.5) / 1000.0, t = 2.4 * i, r = std::sqrt(1.0 - z * z);
    points.push_back(ball.p_C + ball.radius * Eigen::Vector3d(r * std::cos(t), r * std::sin(t), z));
  }
  return points;
}

}  // namespace quadrille::test
