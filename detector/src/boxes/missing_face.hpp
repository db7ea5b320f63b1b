#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "boxes/face.hpp"

namespace quadrille {

/// Looks for a face of a box that was not detected as a plane, since small or far faces have too
/// few samples. It starts where the known faces end, looks at the sensor, is at right angles to
/// them, shares edges with them and is as flat as they are. Its id is 0.
/// @param faces  one or two known faces; the i-th has its normal along column i of the axes
/// @param R_CA   axes of the box in frame C
std::optional<Face> find_missing_face(const std::vector<const Face*>& faces,
                                      const Eigen::Matrix3d& R_CA, const DirectionIndex& sight);

}  // namespace quadrille
