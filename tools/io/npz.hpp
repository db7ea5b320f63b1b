#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// True if bytes begin as a .npz file does.
bool is_npz(std::span<const std::byte> bytes);

/// Reads a .npz file of numpy, packed or not: its array `points`, or the only one besides
/// `viewpoint`, as parse_npy() does. The viewpoint is the array `viewpoint` of shape (3,) [m], else
/// the origin.
/// @param name  stands for the path in errors
/// @param X_CF  turns and moves the file's frame F to frame C of the cloud, before single precision
/// @throws FileError if the file is damaged, an array holds more than 2 GiB, or is no cloud
PointCloud parse_npz(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Isometry3d& X_CF = Eigen::Isometry3d::Identity());

}  // namespace quadrille::io
