#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <vector>

#include "base/mask.hpp"
#include "boxes/face.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Least number of samples of a side, which are enough for a plane.
inline constexpr std::size_t kMinSideSamples = 8;

/// Patches at right angles to each other, one for each side of a thing that may be a box.
using BoxSeed = std::vector<FlatPatch>;

/// The patch around the samples of a side of a box.
/// @param R_CA  right-angled axes, of which the given one leads out of the side
FlatPatch patch_of_side(const SurfaceSamples& samples, std::span<const int> side,
                        const Eigen::Matrix3d& R_CA, int axis);

/// Seeds of boxes in the convex pieces of some samples. The normals of a piece gather about three
/// axes at right angles, though its faces may bulge and its edges be rounded so much that no face
/// is found alone. If a piece stands on a plane, it has a second seed: that of upright_seed().
/// @param free    samples to use
/// @param floors  planes on which things may stand, with unit normals towards the sensor
std::vector<BoxSeed> find_box_seeds(const SurfaceSamples& samples, const Mask& free,
                                    std::span<const Eigen::Hyperplane<double, 3>> floors);

}  // namespace quadrille
