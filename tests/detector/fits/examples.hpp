#pragma once

#include <vector>

#include "fits/normalise.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/depth_camera.hpp"
#include "support/quadric_points.hpp"

namespace quadrille::test {

/// One quadric of each real type that is no single plane.
inline std::vector<CanonicalForm> curved_forms() {
  using T = QuadricType;
  const Eigen::Isometry3d I = Eigen::Isometry3d::Identity();
  return {
      {T::kSphere, I, {{"radius", 0.9}}},
      {T::kEllipsoid, I, {{"a", 1.1}, {"b", 0.8}, {"c", 0.6}}},
      {T::kCylinder, I, {{"radius", 0.6}}},
      {T::kEllipticCylinder, I, {{"a", 0.9}, {"b", 0.5}}},
      {T::kCone, I, {{"half_angle", 0.5}}},
      {T::kEllipticCone, I, {{"half_angle_a", 0.6}, {"half_angle_b", 0.4}}},
      {T::kEllipticParaboloid, I, {{"focal_a", 0.4}, {"focal_b", 0.2}}},
      {T::kHyperbolicParaboloid, I, {{"focal_a", 0.4}, {"focal_b", 0.2}}},
      {T::kHyperboloidOneSheet, I, {{"a", 0.6}, {"b", 0.5}, {"c", 0.9}}},
      {T::kHyperboloidTwoSheets, I, {{"a", 0.6}, {"b", 0.5}, {"c", 0.5}}},
      {T::kHyperbolicCylinder, I, {{"a", 0.5}, {"b", 0.5}}},
      {T::kParabolicCylinder, I, {{"focal", 0.3}}},
      {T::kParallelPlanes, I, {{"distance", 0.8}}},
      {T::kIntersectingPlanes, I, {{"angle", 0.9}}},
  };
}

/// Points of a quadric in a random pose with its gradients as normals.
struct Sampled {
  Quadric Q;
  OrientedPointsd points;
};

/// @param unit  true: unit normals; false: gradients in their full lengths
inline Sampled sample(const CanonicalForm& form, int count, RandomStream& random, bool unit) {
  const Eigen::Isometry3d X = random_pose(random, 0.5);
  const Quadric Q = from_canonical(form);
  Sampled result{Q.transformed(X).normalized(), OrientedPointsd(count)};
  const auto on = points_on(Q.matrix(), count, -1e3, random);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d x = X * on[i].x, g = result.Q.gradient(x);
    result.points.points.col(i) = x;
    result.points.normals.col(i) = unit ? Eigen::Vector3d(g.normalized()) : g;
  }
  return result;
}

inline OrientedPointsd with_noise(OrientedPointsd points, double point_noise, double normal_noise,
                                  RandomStream& random) {
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      points.points(axis, i) += point_noise * gaussian(random);
      points.normals(axis, i) += normal_noise * gaussian(random);
    }
    points.normals.col(i).normalize();
  }
  return points;
}

}  // namespace quadrille::test
