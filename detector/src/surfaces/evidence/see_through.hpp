#pragma once

#include <span>

#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/scene_context.hpp"

namespace quadrille {

/// The share, 0 to 1, of the rays of all views that should meet a quadric but see something behind
/// it. The quadric is tested all around its axis, as far along it as its region reaches. A ball
/// fitted to a bump on something else, for example, would hide what is seen beside it. Spheres and
/// ellipsoids are tested as far as their region reaches along the up direction, if that is known;
/// quadrics without a closed cross section only within their region.
/// @param region  not empty
/// @param form    canonical form of Q, with its axes in frame C
/// @return 0 if there are no rays
double see_through(const SceneContext& context, const SurfaceSamples& samples,
                   std::span<const int> region, const Quadric& Q, const CanonicalForm& form);

}  // namespace quadrille
