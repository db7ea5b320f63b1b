#pragma once

#include <vector>

#include "fit/oriented_points.hpp"
#include "lab/experiments/cylinder_match.hpp"

namespace quadrille::experiments {

/// A matcher of point pairs (Drost, Ulrich, Navab, Ilic, CVPR 2010) whose model is the side of a
/// cylinder of known size; table 2 calls it PPF3D, here for this one model.
struct PairMatcherOptions {
  /// Size of the model [m].
  double radius = 0.018, length = 0.09;
  /// Steps of the features: of distances, relative to the model's diameter, and of angles [rad].
  double distance_step = 0.05, angle_step = 0.2094;
  /// One out of this many scene points is a reference.
  int reference_step = 5;
  /// Least number of votes of a group of poses, as a share of the most votes.
  double min_votes = 0.15;
  /// Least share of half the side, which is what a camera sees of it, that samples must cover; a
  /// plane that touches the side covers a quarter.
  double min_cover = 0.3;
};

/// Returns the cylinders in a cloud, ordered by votes. Each is refined on the points near it, as
/// the paper accepts the result of ICP.
/// @param points  points with outward unit normals, about one per cell
/// @param cell  distance between neighbouring points [m]
std::vector<KnownCylinder> match_pairs(const OrientedPointsd& points, double cell,
                                       const PairMatcherOptions& options);

}  // namespace quadrille::experiments
