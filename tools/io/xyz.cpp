#include "io/xyz.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "io/file_bytes.hpp"
#include "io/header_lines.hpp"

namespace quadrille::io {
namespace {

/// Returns the first three numbers of a line; nullopt if it does not begin with three.
std::optional<Eigen::Vector3d> point_of(std::string_view line) {
  std::string parted(line);
  std::replace(parted.begin(), parted.end(), ',', ' ');
  const std::vector<std::string_view> words = split_words(parted);
  if (words.size() < 3) return std::nullopt;
  Eigen::Vector3d point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> number = to_number(words[static_cast<std::size_t>(axis)]);
    if (!number) return std::nullopt;
    point[axis] = *number;
  }
  return point;
}

}  // namespace

PointCloud parse_xyz(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF) {
  PointCloud cloud;
  TextCursor text(bytes);
  std::size_t number = 0;
  while (!text.at_end()) {
    const std::string_view line = text.next_line().value_or("");
    ++number;
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos || line[first] == '#') continue;
    const std::optional<Eigen::Vector3d> point = point_of(line);
    if (!point) {
      throw FileError(name, "line " + std::to_string(number),
                      "does not begin with three numbers; give a point x y z a line");
    }
    cloud.points.emplace_back((X_CF * *point).cast<float>());
  }
  cloud.viewpoint = X_CF.translation();
  cloud.read = cloud.points.size();
  return cloud;
}

}  // namespace quadrille::io
