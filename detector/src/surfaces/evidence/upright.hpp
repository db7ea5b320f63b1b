#pragma once

#include <optional>

#include "quadrille/detector/canonical.hpp"

namespace quadrille {

/// False for spheres, whose axes are arbitrary, and ellipsoids, whose z is an axis by its length
/// alone.
bool has_axis(QuadricType type);

/// |cosine| of the angle between a quadric's axis and the up direction: what stands has one of 1,
/// what lies of 0; 1 for what has no axis, and where up is unknown.
/// @param form  its axes in the frame of `up`
double uprightness(const CanonicalForm& form, const std::optional<Eigen::Vector3d>& up);

}  // namespace quadrille
