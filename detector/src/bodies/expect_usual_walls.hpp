#pragma once

#include <vector>

#include "bodies/common_axis.hpp"
#include "bodies/walls.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// Moves the two sides of each wall to where its thickness t is likely too.
///
/// A camera sees the near outer and the far inner side of a vessel. They show where its middle is
/// and how large it is, but hardly how thick its wall is: what makes the outer side smaller, the
/// inner one larger and brings both nearer to the camera explains them as well. Most walls are of
/// usual thickness, see usual_wall.hpp. That counts as one more measurement μ ± σ of t, by the
/// update of a Kalman filter. The errors of the parameters θ of all fits are those of their
/// covariance C and what a sensor moves each side by along its normals, s δ, see uncertainty_of().
/// With g = dt/dθ, K = (C g + Σ s sᵀ g var δ) / S and S = var t + σ², the most likely parameters
/// are θ + K (μ − t), and what is left of an error e of the parameters is e − K gᵀ e.
///
/// The other surfaces that were fitted about the same axis move with it. Sides without a common
/// axis are left alone, as is a wall that is surely thicker than 8 mm, or whose surfaces would
/// leave their points. A surface moves with the wall that is known best, of those of which it may
/// be a side.
/// @param samples  of all surfaces
/// @param gaps     receive what is known of the thickness then; those of which a side has moved
///                 with another wall are removed
/// @param axes     the surfaces that were fitted about one axis
/// @return numbers of the surfaces that have another fit now
std::vector<int> expect_usual_walls(const SurfaceSamples& samples, std::vector<WallGap>* gaps,
                                    std::vector<CommonAxis>* axes, std::vector<LastFit>* fits);

}  // namespace quadrille
