#pragma once

#include <span>
#include <vector>

#include "bodies/common_axis.hpp"
#include "quadrille/detector/detection.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// Moves the two sides of each wall to where its thickness t is likely too.
///
/// A camera sees the near outer and the far inner side of a vessel. They show where its middle is
/// and how large it is, but hardly how thick its wall is: what makes the outer side smaller, the
/// inner one larger and brings both nearer to the camera explains them as well. Most walls are of
/// usual thickness, see usual_wall.hpp. That counts as one more measurement μ ± σ of t. With C the
/// covariance of all parameters θ of the fits, g = dt/dθ and S = gᵀ C g + σ², the most likely
/// parameters are θ + C g (μ − t) / S, and their covariance is C − C g gᵀ C / S: the update of a
/// Kalman filter. C has what a sensor moves each side by along its normals, see uncertainty_of().
///
/// The other surfaces that were fitted about the same axis move with it. A thickness that is more
/// than three deviations √S from the usual one is left alone, and so is a surface that has moved
/// with another wall.
/// @param detections  the surfaces as they were measured
/// @param axes        the surfaces that were fitted about one axis
/// @param fits        the surfaces, of the samples
/// @return numbers of the surfaces that have another fit now
std::vector<int> expect_usual_walls(std::span<const Detection> detections,
                                    const SurfaceSamples& samples, std::vector<CommonAxis>* axes,
                                    std::vector<LastFit>* fits);

}  // namespace quadrille
