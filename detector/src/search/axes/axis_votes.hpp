#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/mask.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// A line about which a body may be revolved.
struct Axis {
  /// Any point of the line, in frame C [m].
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  /// Unit vector.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// Finds the axes of a given direction about which bodies of revolution stand.
///
/// The normal line of every point on a surface of revolution meets the axis, so in a plane across
/// the axis the projected lines of the body's walls, shoulders, necks and rims all meet in one
/// point. Each sample at p with unit normal n thus votes for the points
///
///   P p + t P n / |P n|,   |t| from kMinRadius to kMaxRadius cells,   P = I − d dᵀ,
///
/// with a weight that falls with |t|, since the lines of a wide wall spread over more points. The
/// maxima of the votes are then moved to where the lines that pass nearby come closest, in the
/// sense of least squares. A sample whose normal is nearly parallel to d, as on lids, has no
/// direction and does not vote. No random numbers are drawn.
///
/// The votes number twice the radii, in cells, times the samples.
/// @param open       samples that vote; empty for all
/// @param direction  unit vector d
/// @param max_axes   number of axes at most, those with the most votes
std::vector<Axis> vote_for_axes(const SurfaceSamples& samples, const Mask& open,
                                const Eigen::Vector3d& direction, int max_axes);

}  // namespace quadrille
