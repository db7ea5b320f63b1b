#pragma once

#include <vector>

#include "base/mask.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"
#include "search/axes/axis_votes.hpp"
#include "search/candidate.hpp"

namespace quadrille {

/// Searches for cylinders, cones and spheres about known axes.
///
/// With the axis known, one oriented point is a basis. Let r and h be the distance of a point from
/// the axis and its height along it, and (n_r, n_h) its normal in the half-plane through the axis,
/// of unit length. Through it pass
///
///   a cone, which is a cylinder if k is zero:  r − r₀ = k (h − h₀),  k = −n_h / n_r,
///   a sphere:  r² + (h − c)² = R²,  c = h₀ − r₀ n_h / n_r,  R = r₀ / |n_r|.
///
/// A point whose normal is parallel to the axis (n_r = 0, a lid) gives neither, and one whose
/// normal is square to it (n_h = 0) no sphere. Points whose normal line misses the axis are not
/// revolved about it and are left out. Bases are taken evenly from the samples and not drawn. What
/// supports the best of them becomes a candidate, fitted by least squares in (h, r), and is set
/// aside; then the next, on the outer side of the wall and on the inner side alike.
/// @param free     samples that may support a candidate
/// @param threads  number of threads, each at another axis; it never changes the result
/// @return candidates with the most support first, of which none shares most of its samples with
///   those before it
std::vector<Candidate> coaxial_candidates(const SurfaceSamples& samples, const Mask& free,
                                          const std::vector<Axis>& axes, const InlierTest& test,
                                          int min_samples, int threads = 1);

}  // namespace quadrille
