#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads a PLY file: ascii, binary little or big endian, with vertex positions as float or double
/// among any other properties, lists and elements.
///
/// `comment viewpoint X Y Z` gives the position of the sensor [m], and `comment frame NAME` the
/// frame. `comment width W height H` or `obj_info num_cols W`, `num_rows H` make the cloud
/// organised if W x H is the number of vertices.
/// @param name  name of the file in errors
/// @param X_CF  pose of the file's frame F in frame C of the cloud, times the length of the file's
///   unit in metres; applied in double precision
/// @throws FileError if the file is truncated, or of another format
PointCloud parse_ply(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF = Eigen::Affine3d::Identity());

/// Writes float x y z, binary little endian, with the comments that parse_ply() understands.
/// @throws FileError if the file cannot be written
void write_ply(const std::string& path, const PointCloud& cloud);

/// Returns the bytes of such a file.
std::string ply_of(const PointCloud& cloud);

}  // namespace quadrille::io
