#include "base/point_buckets.hpp"

#include <algorithm>
#include <utility>

namespace quadrille {
namespace {

// Cubes are shifted by this share of their edge. Many sensors measure whole millimetres: without
// the shift such points lie on the borders of cubes, where rounding decides to which one they
// belong.
constexpr double kShift = 0.37;
// A key has so many bits for each axis. The places of cubes are limited so that they fit, and that
// their neighbours do.
constexpr int kBits = 21;
constexpr double kFarthest = (1 << (kBits - 1)) - 2;
constexpr PointBuckets::Key kAlongX = PointBuckets::Key{1} << (2 * kBits),
                            kAlongY = PointBuckets::Key{1} << kBits;

}  // namespace

PointBuckets::PointBuckets(std::span<const Eigen::Vector3d> points_C, double edge) {
  std::vector<std::pair<Key, int>> keyed;
  keyed.reserve(points_C.size());
  for (const Eigen::Vector3d& p : points_C) {
    keyed.emplace_back(key_of(p, edge), static_cast<int>(keyed.size()));
  }
  std::sort(keyed.begin(), keyed.end());
  points_.reserve(keyed.size());
  for (const auto& [key, i] : keyed) {
    if (keys_.empty() || key != keys_.back()) {
      keys_.push_back(key);
      first_.push_back(points_.size());
    }
    points_.push_back(i);
  }
  first_.push_back(points_.size());
}

PointBuckets::Key PointBuckets::key_of(const Eigen::Vector3d& p_C, double edge) {
  // Truncation rounds down, since all values are positive by then.
  const Eigen::Array3d cube = (p_C / edge).array() + kShift;
  const Eigen::Array3d from_end = cube.max(-kFarthest).min(kFarthest) + (kFarthest + 2.0);
  return static_cast<Key>(from_end.x()) * kAlongX + static_cast<Key>(from_end.y()) * kAlongY +
         static_cast<Key>(from_end.z());
}

std::vector<PointBuckets::Near> PointBuckets::near_each() const {
  std::vector<Near> all(keys_.size());
  for (std::size_t row = 0; row < 9; ++row) {
    // Cubes are sorted by key. The row of three cubes beside each has keys that ascend, too, so one
    // pass over all cubes finds these rows.
    const Key beside = row / 3 * kAlongX + row % 3 * kAlongY - kAlongX - kAlongY;
    // Unlike vectors, these do not check each access.
    const Key* keys = keys_.data();
    const std::size_t* starts = first_.data();
    std::size_t first = 0, end = 0;
    for (std::size_t n = 0; n < keys_.size(); ++n) {
      const Key middle = keys[n] + beside;
      while (first < keys_.size() && keys[first] < middle - 1) ++first;
      while (end < keys_.size() && keys[end] <= middle + 1) ++end;
      all.data()[n][row] = {points_.data() + starts[first], points_.data() + starts[end]};
    }
  }
  return all;
}

}  // namespace quadrille
