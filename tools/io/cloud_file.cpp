#include "io/cloud_file.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "io/file_bytes.hpp"
#include "io/gzip.hpp"
#include "io/npy/npy.hpp"
#include "io/npy/npy_header.hpp"
#include "io/npy/npz.hpp"
#include "io/pcd/pcd.hpp"
#include "io/ply/ply.hpp"
#include "io/xyz.hpp"

namespace quadrille::io {
namespace {

using Parser = PointCloud (*)(std::span<const std::byte> bytes, const std::string& name,
                              const Eigen::Affine3d& X_CF);

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Returns the parser for a file's extension; nullptr if there is none.
Parser parser_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".gz") return parser_of(path.stem());
  if (extension == ".ply") return parse_ply;
  if (extension == ".pcd") return parse_pcd;
  if (extension == ".xyz") return parse_xyz;
  if (extension == ".npy") return parse_npy;
  if (extension == ".npz") return parse_npz;
  return nullptr;
}

/// Returns the parser for bytes without a file name.
Parser parser_of(std::span<const std::byte> bytes) {
  if (is_npy(bytes)) return parse_npy;
  if (is_npz(bytes)) return parse_npz;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                              std::min<std::size_t>(bytes.size(), 1000));
  if (text.starts_with("ply")) return parse_ply;
  return text.find("FIELDS") != std::string_view::npos ? parse_pcd : parse_xyz;
}

}  // namespace

PointCloud read_cloud(const std::string& path, const Eigen::Affine3d& X_CF) {
  const bool is_input = path == "-";
  const Parser named = parser_of(std::filesystem::path(path));
  if (!is_input && !named) {
    if (!std::filesystem::exists(path)) throw FileError(path, "", "no such file; check the path");
    throw FileError(
        path, "",
        "unknown kind of file; give a .ply, .pcd, .xyz, .npy or .npz file, or (to detect "
        "and plan) an LCM log");
  }
  const std::string name = is_input ? "standard input" : path;
  std::vector<std::byte> bytes = is_input ? read_standard_input() : read_file(path);
  if (is_input && bytes.empty()) throw FileError(name, "", "is empty; pipe a cloud into it");
  if (is_gzip(bytes)) bytes = gunzip(bytes, name);
  return (is_input ? parser_of(std::span<const std::byte>(bytes)) : named)(bytes, name, X_CF);
}

}  // namespace quadrille::io
