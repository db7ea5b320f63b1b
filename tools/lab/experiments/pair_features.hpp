#pragma once

#include <vector>

#include "fit/oriented_points.hpp"
#include "lab/experiments/cylinder_match.hpp"

namespace quadrille::experiments {

/// A matcher of point pairs (Drost, Ulrich, Navab, Ilic, CVPR 2010) whose model is the side of a
/// cylinder of known size: what table 2 calls PPF3D, for this one model.
struct PairMatcherOptions {
  /// Of the model [m].
  double radius = 0.018, length = 0.09;
  /// Steps of the features: of distances, in diameters of the model, and of angles [rad].
  double distance_step = 0.05, angle_step = 0.2094;
  /// Each so many scene points one is a reference.
  int reference_step = 5;
  /// Least share of the most votes that a group of poses has.
  double min_votes = 0.15;
  /// Least share of half the side, what a camera sees of it, that samples cover; a plane that
  /// touches it covers a quarter.
  double min_cover = 0.3;
};

/// The cylinders in a cloud, those with most votes first; each refined on the points near it, as
/// the paper accepts what ICP converges to.
/// @param points  with unit normals to the outside, about one a cell
/// @param cell    distance of neighbours among them [m]
std::vector<KnownCylinder> match_pairs(const OrientedPointsd& points, double cell,
                                       const PairMatcherOptions& options);

}  // namespace quadrille::experiments
