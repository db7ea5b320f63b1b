#pragma once

#include <Eigen/Geometry>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads a cloud from a .ply, .pcd, .xyz, .npy or .npz file, any of them packed by gzip (.ply.gz);
/// of "-", the standard input, the first bytes tell which it is.
/// @param X_CF  turns and moves the file's frame F to frame C of the cloud, before single precision
/// @throws FileError if the file is missing, cut short, or of another format
PointCloud read_cloud(const std::string& path,
                      const Eigen::Isometry3d& X_CF = Eigen::Isometry3d::Identity());

}  // namespace quadrille::io
