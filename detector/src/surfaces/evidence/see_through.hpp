#pragma once

#include <span>

#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/scene_context.hpp"

namespace quadrille {

inline constexpr double kUnknownShare = 0.6;

/// The share, 0 to 1, of the rays of all views that should meet a quadric but see something behind
/// it. The quadric is tested all around its axis, as far along it as its region reaches. A ball
/// fitted to a bump on something else, for example, would hide what is seen beside it. Spheres and
/// ellipsoids are tested as far as their region reaches along the up direction, if that is known;
/// quadrics without a closed cross section only within their region.
/// @param region  not empty
/// @param form    canonical form of Q, with its axes in frame C
///
/// Nothing contradicts a false surface in a cloud that was joined from several views, since nobody
/// knows what their sensors saw beside it. There all surfaces count as seen through by
/// kUnknownShare, so that the other evidence must be stronger. Of eight joined clouds of simulated
/// stereo kitchens on which the share was chosen, and of eight others, it leaves 12 of 45 false
/// surfaces and 94 of 97 true ones.
/// @return 0 if no ray of a view should meet the quadric
double see_through(const SceneContext& context, const SurfaceSamples& samples,
                   std::span<const int> region, const Quadric& Q, const CanonicalForm& form);

}  // namespace quadrille
