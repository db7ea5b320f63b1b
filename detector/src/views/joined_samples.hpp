#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "base/mask.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// The samples of several views in one list, view by view. Samples are neighbours only within their
/// own view.
/// @param views        samples of each view, all in frame C
/// @param first_cells  what is added to the sources of each view's samples
/// @param view_shift   see SurfaceSamples [m]; it adds to the noise of each sample
SurfaceSamples joined_samples(std::span<const SurfaceSamples* const> views,
                              const std::vector<int>& first_cells, double view_shift);

/// The measured positions of the samples of several views in one list, with their normals, noise
/// and cells; all else is left out.
SurfaceSamples joined_places(std::span<const SurfaceSamples* const> views);

/// The samples after a rigid motion.
SurfaceSamples moved(SurfaceSamples samples, const Eigen::Isometry3d& X);

/// Makes some samples of different views neighbours if they lie within a cell of each other.
/// @param some  nonzero for those samples
SurfaceSamples linked_views(SurfaceSamples samples, const Mask& some);

}  // namespace quadrille
