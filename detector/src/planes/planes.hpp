#pragma once

#include <optional>
#include <vector>

#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// One plane n·x + d = 0, n towards the viewpoint.
struct PlaneRegion {
  Eigen::Vector4d plane;
  std::vector<int> samples;
};

/// Distance from a plane over the distance along it that the waves of a sensor may feign: tables
/// and walls come in pieces that are bent this much, and more than noise within a patch explains.
inline constexpr double kMaxWaviness = 0.015;

/// Mean of the samples' raw positions.
Eigen::Vector3d middle_of(const SurfaceSamples& samples, const PlaneRegion& plane);

/// Grows planes over neighbours from the flattest seeds (type-specific fit: one oriented point
/// determines a plane, paper, table of minimal cases).
/// @param claimed  per sample, nonzero to leave it out; empty for none
std::vector<PlaneRegion> find_planes(const SurfaceSamples& samples, const PlaneOptions& options,
                                     const std::vector<char>& claimed = {});

/// Normal of the plane with the most samples; nullopt without planes.
std::optional<Eigen::Vector3d> normal_of_largest(const std::vector<PlaneRegion>& planes);

}  // namespace quadrille
