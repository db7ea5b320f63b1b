#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fit/oriented_point.hpp"
#include "lab/printed/settings.hpp"
#include "samples/sample_tree.hpp"
#include "search/basis.hpp"
#include "search/candidate.hpp"

namespace quadrille::printed {

/// The pencil of a basis as printed (paper, eq. 5 and 6): Q₀ is the solution of least norm of the
/// compact system with weight w, and the plane squared, its null vector (theorem 1), has the norm
/// λ₀, so that λ of the pencil is λ / λ₀ of the paper.
/// @param basis  points in the unit ball, with unit normals
/// @return nullopt if the points are collinear or the system has not rank 9
std::optional<Pencil> printed_pencil(const std::array<OrientedPoint, 3>& basis, double weight,
                                     double lambda_scale);

/// Draws bases all over a level, has all of its samples vote on each, and returns the quadric of
/// each peak with all of the finest samples on it, wherever they are (paper, section 4).
/// @param open     per sample of the level, zero to leave it out
/// @param options  `search.radii`, of which the largest limits a basis, `search.voters`, `inlier`,
///   `aggregate.min_samples` and `seed` are used
std::vector<Candidate> pool_hypotheses(const SampleTree& tree, int level, const Mask& open,
                                       const DetectorOptions& options,
                                       const PrintedOptions& printed);

}  // namespace quadrille::printed
