#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Points as text: a line each, x, y and z first, parted by white space or commas; the rest of a
/// line is passed over, as are empty lines and those that begin with #.
/// @param name  stands for the path in errors
/// @param X_CF  turns and moves the file's frame F to frame C of the cloud, before single precision
/// @throws FileError naming the line that does not begin with three numbers
PointCloud parse_xyz(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Isometry3d& X_CF = Eigen::Isometry3d::Identity());

}  // namespace quadrille::io
