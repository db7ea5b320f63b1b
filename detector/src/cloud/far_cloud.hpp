#pragma once

#include <Eigen/Core>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// True if a cloud's centre [m] is so far from the origin that squares of coordinates in single
/// precision lose the noise. Such clouds typically come in the frame of a map.
bool is_far(const Eigen::Vector3d& centre);

/// Returns the points and the viewpoint moved by a shift [m]; the name of the frame is dropped.
PointCloud translated(const CloudView& cloud, const Eigen::Vector3d& shift);

/// Returns the detection moved by a shift [m].
Detection translated(Detection detection, const Eigen::Vector3d& shift);

}  // namespace quadrille
