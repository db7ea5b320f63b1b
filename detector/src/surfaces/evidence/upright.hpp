#pragma once

#include <optional>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// |cosine| between a quadric's axis and the up direction: 1 if it stands, 0 if it lies; 1 also for
/// types without an axis, and if the up direction is unknown. The axes of spheres are arbitrary,
/// and the z axis of ellipsoids is distinguished only by its length.
/// @param form  canonical form with its axes in the frame of `up`
double uprightness(const CanonicalForm& form, const std::optional<Eigen::Vector3d>& up);

}  // namespace quadrille
