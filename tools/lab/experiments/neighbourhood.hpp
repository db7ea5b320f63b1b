#pragma once

#include <vector>

#include "base/random.hpp"
#include "fit/geometric_fit.hpp"
#include "fits/normalise.hpp"

namespace quadrille::experiments {

/// A piece of a random quadric in the unit ball, observed with noise among pieces of planes.
struct Neighbourhood {
  /// Noisy points with noisy unit normals of the quadric and of the planes, in random order.
  OrientedPointsd points;
  /// The same points as floats, for the vote.
  OrientedPointsf voters;
  /// Exact points and normals of the quadric.
  OrientedPointsd truth;
};

/// How a neighbourhood is drawn.
struct NeighbourhoodOptions {
  Eigen::Index size = 300;
  /// Share of points on three random planes through the ball.
  double outliers = 0.0;
  /// Standard deviations of a coordinate [radii of the ball] and of a normal [rad about each axis].
  double point_noise = 0.01, normal_noise = 0.1;
};

Neighbourhood random_neighbourhood(const NeighbourhoodOptions& options, RandomStream& random);

/// Returns true if the quadric follows the true surface of a neighbourhood: nine tenths of it lie
/// within `distance`, with a cosine of at least 0.9 between the normals.
bool is_found(const Quadric& Q, const Neighbourhood& neighbourhood, double distance);

}  // namespace quadrille::experiments
