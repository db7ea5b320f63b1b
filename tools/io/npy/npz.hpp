#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Returns true if the bytes begin like a .npz file.
bool is_npz(std::span<const std::byte> bytes);

/// Reads numpy's .npz file, compressed or not. The cloud is the array `points`, or the only one
/// besides `viewpoint`, in the form of parse_npy(). The viewpoint is the array `viewpoint` of shape
/// (3,) [m], or the origin if it is missing.
/// @param name  name of the file in errors
/// @param X_CF  pose of the file's frame F in frame C of the cloud, times the length of the file's
///   unit in metres; applied in double precision
/// @throws FileError if the file is damaged, or an array holds more than 2 GiB or is not a cloud
PointCloud parse_npz(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF = Eigen::Affine3d::Identity());

}  // namespace quadrille::io
