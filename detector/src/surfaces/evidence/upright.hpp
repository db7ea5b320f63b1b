#pragma once

#include <optional>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// False for spheres, whose axes are arbitrary, and for ellipsoids, whose z axis is distinguished
/// only by its length.
bool has_axis(QuadricType type);

/// |cosine| between a quadric's axis and the up direction: 1 if it stands, 0 if it lies; 1 also for
/// types without an axis, and if the up direction is unknown.
/// @param form  canonical form with its axes in the frame of `up`
double uprightness(const CanonicalForm& form, const std::optional<Eigen::Vector3d>& up);

}  // namespace quadrille
