#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fit/oriented_points.hpp"
#include "samples/sight.hpp"
#include "surfaces/lid_outline.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// A surface with its last fit, and the points of that fit in the surface's local coordinates. A
/// surface that was not refitted has none.
struct LastFit {
  Surface surface;
  OrientedPointsf points;
  /// Number of the points that are samples. They come first; the others are of a lid's outline.
  Eigen::Index samples = 0;

  /// The points that move if the sensor moves the surface along its normals. Edges stay where they
  /// are in the image.
  OrientedPointsf wall() const { return points.first(samples); }
};

/// Refits a curved surface to all its samples but those at its outline, each moved to where the
/// surface runs through its cell.
///
/// The mean m of the points in a cell lies on the hollow side of the surface. If S is the
/// covariance of the points along the surface, the mean of f = xᵀQx over them is f(m) + tr(Q₃ S),
/// with Q₃ the quadratic part of Q. It is zero if the points lie on the surface, so that m is tr(Q₃
/// S) / |∇f| off.
/// @param scatter  covariance of the points in each sample's cell [m²]; see scatter_in_cells()
/// @param sights   the views, whose depth noise does not count as scatter; in a view without cells,
///   the noise is taken to lie along the normals
/// @param outline  the outline of lids that may close the surface; empty if it is no cylinder. It
///   shows whether the section is round or elliptic; see fit_closed(). If the fits with and without
///   it have the same type, the one with the smaller deviations is taken
/// @return the surface unchanged if it is a plane or if the refit to its samples is of another type
LastFit last_fit(Surface surface, const SurfaceSamples& samples,
                 const std::vector<Eigen::Matrix3f>& scatter, const std::vector<Sight>& sights,
                 std::span<const OutlinePoint> outline = {});

}  // namespace quadrille
