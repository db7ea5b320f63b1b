#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads a .npy file of numpy: floats of 4 or 8 bytes of shape (N, 3), or (H, W, 3) of an organised
/// cloud, or records with the fields x, y and z of shape (N,) or (H, W). Names no viewpoint: that
/// is the origin.
/// @param name  stands for the path in errors
/// @param X_CF  turns and moves the file's frame F to frame C of the cloud, before single precision
/// @throws FileError if the file is cut short, or of another format, type or shape
PointCloud parse_npy(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Isometry3d& X_CF = Eigen::Isometry3d::Identity());

/// Three numbers: floats of 4 or 8 bytes of shape (3,).
/// @throws FileError as above
Eigen::Vector3d parse_npy_vector(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadrille::io
