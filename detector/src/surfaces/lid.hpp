#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "samples/sight.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// The flat end of a body as one view saw it, such as the top of a can.
struct Lid {
  /// Pose of frame L in frame C. Its origin is the middle of the seen part, and z is the lid's
  /// outward normal.
  Eigen::Isometry3d X_CL = Eigen::Isometry3d::Identity();
  /// The places that the view's cells on the lid show, in frame C [m].
  std::vector<Eigen::Vector3d> places_C;
  /// Mean edge of the wall's cells [m].
  double cell = 0.0;
};

/// Finds the flat ends that a view saw of a curved surface with an axis: cells next to an end of
/// its samples, on the side of the axis, and all that continue them in a plane at right angles to
/// the axis. An end that was seen from below, or from inside the surface, gives none.
/// @return at most one for each end; none if the view has no cells
std::vector<Lid> find_lids(const Surface& surface, const SurfaceSamples& samples,
                           const Sight& sight);

}  // namespace quadrille
