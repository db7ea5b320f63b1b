#pragma once

#include <span>
#include <vector>

#include "quadrille/detector/geometric_fit.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/surface_samples.hpp"

namespace quadrille {

/// Similarity that carries a region's points to about the unit ball: x_local = (x − centre) /
/// scale.
struct Normalisation {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double scale = 1.0;

  /// The quadric of local coordinates in the frame of the samples.
  Quadric to_frame(const Eigen::Matrix4d& Q_local) const;
  /// The inverse.
  Eigen::Matrix4d to_local(const Quadric& Q) const;
};

/// Centre and mean square radius of the raw positions of a region.
Normalisation normalisation_of(const SurfaceSamples& samples, std::span<const int> region);

/// The region if it has at most so many samples, else that many, spread evenly; some of them
/// twice where it has hardly more.
std::vector<int> spread_evenly(std::span<const int> region, std::size_t most);

/// Up to `most` points of a region (spread evenly), raw positions in local coordinates.
FitPoints fit_points(const SurfaceSamples& samples, std::span<const int> region,
                     const Normalisation& normalisation, int most);

struct InlierTest {
  /// Largest distance in multiples of a sample's sigma, plus a share of its cell.
  double sigmas = 3.0, cells = 0.1;
  /// Least |cosine| between normal and gradient; -1 to ignore normals.
  double least_cosine = 0.9;
};

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

/// Independent measurements per sample, 0 to 1, from the correlation ρ of the residuals of
/// neighbours: ((1 − ρ) / (1 + ρ))², as for noise that decays exponentially along two axes. The
/// noise of depth sensors comes in waves, and many samples know less than they seem to.
double effective_share(const SurfaceSamples& samples, std::span<const int> region,
                       const Quadric& Q);

}  // namespace quadrille
