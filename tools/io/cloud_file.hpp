#pragma once

#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads a cloud from a .ply or .pcd file.
/// @throws FileError if the file is missing, cut short, or of another format
PointCloud read_cloud(const std::string& path);

}  // namespace quadrille::io
