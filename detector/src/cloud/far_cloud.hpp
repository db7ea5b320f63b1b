#pragma once

#include <Eigen/Core>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Returns the shift to the origin [m], in whole metres, of a cloud whose centre is so far from it
/// that squares of coordinates in single precision lose the noise; zero for any other cloud. Far
/// clouds typically come in the frame of a map.
Eigen::Vector3d shift_to_origin(const Eigen::Vector3d& centre);

/// Returns the points and the viewpoint moved by a shift [m]; the name of the frame is dropped.
PointCloud translated(const CloudView& cloud, const Eigen::Vector3d& shift);

/// Returns the detection moved by a shift [m].
Detection translated(Detection detection, const Eigen::Vector3d& shift);

}  // namespace quadrille
