#pragma once

#include <span>

#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/scene_context.hpp"

namespace quadrille {

/// The share that see_through() returns where no view has rays.
///
/// Nothing contradicts a false surface in a cloud that was joined from several views, since nobody
/// knows what their sensors saw beside it. So the other evidence for each surface must be stronger
/// there, as if much were seen through it. Of eight joined clouds of simulated stereo kitchens, on
/// which the share was not chosen, it leaves 6 of 17 false surfaces and 38 of 40 true ones.
inline constexpr double kUnknownShare = 0.6;

/// The share, 0 to 1, of the rays of all views that should meet a quadric but see something behind
/// it. The quadric is tested all around its axis, as far along it as its region reaches. A ball
/// fitted to a bump on something else, for example, would hide what is seen beside it. Spheres and
/// ellipsoids are tested as far as their region reaches along the up direction, if that is known;
/// quadrics without a closed cross section only within their region.
/// @param region  not empty
/// @param form    canonical form of Q, with its axes in frame C
/// @return kUnknownShare if no view has rays; 0 if none of their rays should meet the quadric
double see_through(const SceneContext& context, const SurfaceSamples& samples,
                   std::span<const int> region, const Quadric& Q, const CanonicalForm& form);

}  // namespace quadrille
