#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads a PCD file (versions 0.5 to 0.7; ascii, binary, binary_compressed) whose fields x, y, z
/// are floats of 4 or 8 bytes among any others. The translation of VIEWPOINT becomes the viewpoint;
/// a HEIGHT above 1 makes the cloud organised.
/// @param name  name of the file in errors
/// @param X_CF  pose of the file's frame F in frame C of the cloud, times the length of the file's
///   unit in metres; applied in double precision
/// @throws FileError if the file is truncated, or of another format
PointCloud parse_pcd(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF = Eigen::Affine3d::Identity());

}  // namespace quadrille::io
