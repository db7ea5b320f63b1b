#pragma once

#include <optional>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// Gives a surface another fit, in its local coordinates, with the quadric and the residual that
/// follow from it. What its points tell about the fit stays as it was.
void set_fit(Surface* surface, FamilyFit fit);

/// Makes the surface of a region from a fit to some of its points, without evidence.
/// @param local  map to the coordinates of the fit
/// @param points  the points of the fit
Surface surface_of(std::vector<int> region, const Normalisation& local, FamilyFit fit,
                   const OrientedPointsf& points);

/// Fits the surface of the family that explains a region best, without evidence; nullopt if nothing
/// fits.
std::optional<Surface> fit_surface(const SurfaceSamples& samples, std::vector<int> region,
                                   const AggregateOptions& options);

/// Fits the plane of a region, without evidence; nullopt if the noise does not explain its
/// residual.
std::optional<Surface> fit_plane(const SurfaceSamples& samples, std::vector<int> region,
                                 const AggregateOptions& options);

}  // namespace quadrille
