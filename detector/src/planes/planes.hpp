#pragma once

#include <optional>
#include <vector>

#include "base/mask.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// One plane n·x + d = 0 with n towards the viewpoint, and the samples on it.
struct PlaneRegion {
  Eigen::Vector4d plane;
  std::vector<int> samples;
};

/// Largest ratio between the distance from a plane and the distance along it that a sensor's waves
/// explain. Real tables and walls are found in pieces bent by this much, which is more than the
/// noise within a patch explains.
inline constexpr double kMaxWaviness = 0.015;

/// Mean of the raw positions of the plane's samples [m].
Eigen::Vector3d middle_of(const SurfaceSamples& samples, const PlaneRegion& plane);

/// Grows planes over neighbours from the flattest seeds. This is a type-specific fit: one oriented
/// point determines a plane (paper, table of minimal cases).
/// @param free  samples to use
std::vector<PlaneRegion> find_planes(const SurfaceSamples& samples, const PlaneOptions& options,
                                     const Mask& free = {});

/// Normal of the plane with the most samples; nullopt without planes.
std::optional<Eigen::Vector3d> normal_of_largest(const std::vector<PlaneRegion>& planes);

}  // namespace quadrille
