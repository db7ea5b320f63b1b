#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fit/geometric_fit.hpp"
#include "quadrille/detector/quadric.hpp"
#include "search/basis.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

inline Eigen::Isometry3d random_pose(RandomStream& random, double shift) {
  const auto u = [&] { return 2.0 * random.uniform() - 1.0; };
  const double w = u(), x = u(), y = u(), z = u();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  for (int axis = 0; axis < 3; ++axis) X.translation()[axis] = shift * u();
  return X;
}

/// Points of a quadric near its origin with unit gradients as normals, by Newton steps along the
/// gradient from random points; only those with z of at least `low`.
inline std::vector<OrientedPoint> points_on(const Eigen::Matrix4d& D, int count, double low,
                                            RandomStream& random) {
  const Quadric Q(D);
  std::vector<OrientedPoint> points;
  while (static_cast<int>(points.size()) < count) {
    Eigen::Vector3d x;
    for (int axis = 0; axis < 3; ++axis) x[axis] = 2.4 * random.uniform() - 1.2;
    for (int step = 0; step < 30; ++step) {
      const Eigen::Vector3d g = Q.gradient(x);
      x -= Q.value(x) / g.squaredNorm() * g;
    }
    const Eigen::Vector3d g = Q.gradient(x);
    const bool on = std::abs(Q.value(x)) < 1e-13 && g.norm() > 0.1;
    if (on && x.norm() < 1.5 && x.z() >= low) points.push_back({x, g.normalized()});
  }
  return points;
}

template <typename Scalar>
OrientedPoints<Scalar> to_oriented_points(const std::vector<OrientedPoint>& list) {
  OrientedPoints<Scalar> result(static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result.points.col(i) = list[i].x.cast<Scalar>();
    result.normals.col(i) = list[i].n.cast<Scalar>();
  }
  return result;
}

inline OrientedPointsf to_fit_points(const std::vector<OrientedPoint>& points) {
  return to_oriented_points<float>(points);
}

/// Mean |distance| of the points from a quadric, and mean cosine between its gradients and the
/// normals.
inline std::pair<double, double> mean_agreement(const Eigen::Matrix4d& matrix,
                                                const OrientedPointsf& points) {
  const Quadric Q(matrix);
  double distance = 0, cosine = 0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    distance += std::abs(Q.distance(points.at(i).x));
    cosine += Q.gradient(points.at(i).x).normalized().dot(points.at(i).n);
  }
  const double n = static_cast<double>(points.size());
  return {distance / n, cosine / n};
}

/// A quadric of a family and where its points are taken.
struct FamilyExample {
  Family family;
  std::string name;
  Eigen::Matrix4d D;
  double low = -1e3;
};

inline std::vector<FamilyExample> family_examples() {
  Eigen::Matrix4d plane = Eigen::Matrix4d::Zero(), paraboloid = diagonal(1, 1, 0, 0);
  Eigen::Matrix4d elliptic = diagonal(1, 2, 0, 0);
  elliptic(2, 3) = elliptic(3, 2) = -0.4;
  plane(2, 3) = plane(3, 2) = 0.5;
  paraboloid(2, 3) = paraboloid(3, 2) = -0.4;
  return {
      {Family::kPlane, "plane", plane},
      {Family::kSphere, "sphere", diagonal(1, 1, 1, -0.81)},
      {Family::kCylinder, "cylinder", diagonal(1, 1, 0, -0.49)},
      {Family::kCone, "cone", diagonal(1, 1, -0.36, 0), 0.3},
      {Family::kParaboloid, "paraboloid", paraboloid},
      {Family::kRevolution, "hyperboloid of revolution", diagonal(1, 1, -0.6, -0.3)},
      {Family::kParabolic, "elliptic paraboloid", elliptic},
      {Family::kEllipticCylinder, "elliptic cylinder", diagonal(1, 3, 0, -0.8)},
      {Family::kGeneral, "ellipsoid", diagonal(1, 1.8, 3, -1)},
  };
}

/// Oriented points of an example in a random pose, displaced by noise along their normals.
struct ExamplePoints {
  OrientedPointsf points;
  PosedQuadric truth;
};

inline ExamplePoints make_points(const FamilyExample& example, int count, double noise,
                                 RandomStream& random) {
  ExamplePoints result;
  result.truth.D = example.D;
  result.truth.X = random_pose(random, 0.2);
  std::vector<OrientedPoint> points = points_on(example.D, count, example.low, random);
  for (OrientedPoint& point : points) {
    point.x = result.truth.X * (point.x + noise * gaussian(random) * point.n);
    point.n = result.truth.X.linear() * point.n;
  }
  result.points = to_fit_points(points);
  return result;
}

/// How far two quadrics differ, whatever their scale and sign.
inline double difference(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b) {
  const Eigen::Matrix4d A = Quadric(a).normalized().matrix();
  const Eigen::Matrix4d B = Quadric(b).normalized().matrix();
  return std::min((A - B).norm(), (A + B).norm());
}

}  // namespace quadrille::test
