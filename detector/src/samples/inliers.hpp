#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Signed first-order distance f / |∇f| of a position to Q, in single precision [m].
inline float distance_to(const Eigen::Matrix4f& Q, const Eigen::Vector3f& x) {
  const Eigen::Vector4f h = Q * x.homogeneous();
  return x.homogeneous().dot(h) / (2.0f * h.head<3>().norm());
}

/// True if sample i lies on Q with a compatible normal, up to sign: on surfaces seen inside and
/// outside, normals towards the camera contradict the gradient.
bool is_inlier(const SurfaceSamples& samples, int i, const Eigen::Matrix4f& Q,
               const InlierTest& test);

/// The samples connected to the start by neighbours that are inliers of Q.
/// @param free  per sample, zero to stay out of it
std::vector<int> connected_inliers(const SurfaceSamples& samples, std::span<const int> start,
                                   const Quadric& Q, const InlierTest& test,
                                   const std::vector<char>& free);

}  // namespace quadrille
