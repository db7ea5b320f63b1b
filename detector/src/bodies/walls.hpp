#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "bodies/common_axis.hpp"
#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// A wall of which both sides were seen.
struct SeenWall {
  /// Numbers of the surfaces, or ids of the detections, of its outer and its inner side.
  int outer, inner;
  BodyWall measured;
};

/// The distance from the inner to the outer one of two surfaces.
struct WallGap {
  /// Numbers of the surfaces.
  int outer, inner;
  /// The distance, negative if the inner one lies outside, and its standard deviation [m].
  double thickness, std;
  /// Derivative of the distance by the parameters of each surface's family.
  Eigen::VectorXd by_outer, by_inner;
};

/// Finds pairs of surfaces about one axis that may be the two sides of a wall, and measures the
/// distance between them.
///
/// One side was seen from outside and the other from inside, and they overlap along the axis. The
/// distance is measured along the normals, as a mean over the heights of the overlap: a place
/// midway between the two sides lies within the outer one by −f/|∇f|, and beyond the inner one by
/// f/|∇f|.
///
/// Its variance follows from the covariance of the parameters of both fits. Surfaces that were
/// fitted about one axis share the errors of its place, which move the near outer and the far inner
/// side of a wall to opposite sides. What a sensor moves a whole surface by along its normals, see
/// uncertainty_of(), is added for each side. It is taken to be independent on the two sides.
/// @param detections  the surfaces as they were measured
/// @param fits        the surfaces, of the samples
/// @param axes        the surfaces that were fitted about one axis
std::vector<WallGap> find_gaps(std::span<const Detection> detections,
                               const std::vector<LastFit>& fits, const SurfaceSamples& samples,
                               std::span<const CommonAxis> axes);

/// The gaps that are larger than their deviation.
std::vector<SeenWall> seen_walls(std::span<const WallGap> gaps);

}  // namespace quadrille
