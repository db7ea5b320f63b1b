#pragma once

#include <Eigen/Geometry>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads a cloud from a .ply, .pcd, .xyz, .npy or .npz file, which may be compressed by gzip
/// (.ply.gz). The path "-" stands for the standard input, whose first bytes determine the format.
/// @param X_CF  pose of the file's frame F in frame C of the cloud, times the length of the file's
///   unit in metres; applied in double precision
/// @throws FileError if the file is missing, truncated, or of another format
PointCloud read_cloud(const std::string& path,
                      const Eigen::Affine3d& X_CF = Eigen::Affine3d::Identity());

}  // namespace quadrille::io
