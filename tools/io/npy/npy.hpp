#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads numpy's .npy file: floats of 4 or 8 bytes of shape (N, 3), or (H, W, 3) for an organised
/// cloud, or records with the fields x, y and z of shape (N,) or (H, W). The format has no
/// viewpoint, so it is the origin.
/// @param name  name of the file in errors
/// @param X_CF  pose of the file's frame F in frame C of the cloud, times the length of the file's
///   unit in metres; applied in double precision
/// @throws FileError if the file is truncated, or of another format, type or shape
PointCloud parse_npy(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF = Eigen::Affine3d::Identity());

/// Reads three numbers: floats of 4 or 8 bytes of shape (3,).
/// @throws FileError as parse_npy() does
Eigen::Vector3d parse_npy_vector(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadrille::io
