#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "base/marks.hpp"
#include "base/mask.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Signed first-order distance f / |∇f| of a position from Q, in single precision [m].
inline float distance_to(const Eigen::Matrix4f& Q, const Eigen::Vector3f& x) {
  const Eigen::Vector4f h = Q * x.homogeneous();
  return x.homogeneous().dot(h) / (2.0f * h.head<3>().norm());
}

/// True if sample i lies on Q with a compatible normal, up to sign. On surfaces seen both inside
/// and outside, normals towards the camera contradict the gradient on one side.
bool is_inlier(const SurfaceSamples& samples, int i, const Eigen::Matrix4f& Q,
               const InlierTest& test);

/// Returns the inliers of Q that are connected to the start through neighbouring inliers.
/// @param free  samples that may be inliers
/// @param seen  buffer, of the size of the samples
std::vector<int> connected_inliers(const SurfaceSamples& samples, std::span<const int> start,
                                   const Quadric& Q, const InlierTest& test, const Mask& free,
                                   Marks* seen);

}  // namespace quadrille
