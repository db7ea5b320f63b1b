#pragma once

#include <Eigen/Core>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// True if a cloud's centre, in its frame [m], is so far from the origin that single precision
/// loses its noise in the squares of the coordinates. Such clouds come in the frame of a map.
bool is_far(const Eigen::Vector3d& centre);

/// The points and the viewpoint moved by a shift [m], without the name of their frame.
PointCloud translated(const CloudView& cloud, const Eigen::Vector3d& shift);

/// The detection moved by a shift [m].
Detection translated(Detection detection, const Eigen::Vector3d& shift);

}  // namespace quadrille
