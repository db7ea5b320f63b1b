#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// Reads a PCD file (versions 0.5 to 0.7; ascii, binary, binary_compressed) whose fields x, y, z
/// are floats of 4 or 8 bytes among any others. The translation of VIEWPOINT becomes the viewpoint;
/// a HEIGHT above 1 makes the cloud organised.
/// @throws FileError if the file is missing, cut short, or of another format
PointCloud read_pcd(const std::string& path);

/// The same from memory; `name` stands for the path in errors.
PointCloud parse_pcd(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadrille::io
