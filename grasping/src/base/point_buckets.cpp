#include "base/point_buckets.hpp"

#include "base/sorted_keys.hpp"

namespace quadrille {
PointBuckets::PointBuckets(std::span<const Eigen::Vector3d> points_C, double edge) {
  std::vector<Keyed> keyed;
  keyed.reserve(points_C.size());
  for (const Eigen::Vector3d& p : points_C) {
    keyed.push_back({key_of(p, edge), static_cast<int>(keyed.size())});
  }
  sort_by_key(&keyed);
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
