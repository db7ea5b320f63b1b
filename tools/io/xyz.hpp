#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads points as text, one per line: x, y and z first, separated by white space or commas. The
/// rest of a line is ignored, as are empty lines and those that begin with #.
/// @param name  name of the text in errors
/// @param X_CF  pose of the file's frame F in frame C of the cloud, times the length of the file's
///   unit in metres; applied in double precision
/// @throws FileError naming the line that does not begin with three numbers
PointCloud parse_xyz(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF = Eigen::Affine3d::Identity());

}  // namespace quadrille::io
