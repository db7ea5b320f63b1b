#include "io/cloud_file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "io/file_bytes.hpp"
#include "io/pcd.hpp"
#include "io/ply.hpp"

namespace quadrille::io {

PointCloud read_cloud(const std::string& path, const Eigen::Isometry3d& X_CF) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".ply") return read_ply(path, X_CF);
  if (extension == ".pcd") return read_pcd(path, X_CF);
  if (!std::filesystem::exists(path)) throw FileError(path, "", "no such file; check the path");
  throw FileError(
      path, "",
      "unknown kind of file; give a .ply or .pcd file, or (to detect and plan) an LCM log");
}

}  // namespace quadrille::io
