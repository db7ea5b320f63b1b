#include "base/point_buckets.hpp"

#include <algorithm>
#include <utility>

namespace quadrille {
namespace {

// Cubes are shifted by this share of their edge. Many sensors measure whole millimetres: without
// the shift such points lie on the borders of cubes, where rounding decides to which one they
// belong.
constexpr double kShift = 0.37;

}  // namespace

PointBuckets::PointBuckets(std::span<const Eigen::Vector3d> points_C, double edge) {
  std::vector<std::pair<Key, int>> keyed;
  keyed.reserve(points_C.size());
  for (const Eigen::Vector3d& p : points_C) {
    keyed.emplace_back(key_of(p, edge), static_cast<int>(keyed.size()));
  }
  std::sort(keyed.begin(), keyed.end());
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
  const Eigen::Vector3i key = ((p_C / edge).array() + kShift).floor().cast<int>();
  return {key.x(), key.y(), key.z()};
}

std::vector<int> PointBuckets::near(const Key& key) const {
  const auto begin_of = [&](std::vector<Key>::const_iterator cube) {
    return static_cast<std::ptrdiff_t>(first_[static_cast<std::size_t>(cube - keys_.begin())]);
  };
  std::vector<int> points;
  for (int n = 0; n < 9; ++n) {
    const int x = key[0] + n / 3 - 1, y = key[1] + n % 3 - 1;
    // The three cubes of a row along z lie side by side.
    const auto low = std::lower_bound(keys_.begin(), keys_.end(), Key{x, y, key[2] - 1});
    const auto high = std::find_if(low, keys_.end(), [&](const Key& other) {
      return other > Key{x, y, key[2] + 1};
    });
    points.insert(points.end(), points_.begin() + begin_of(low), points_.begin() + begin_of(high));
  }
  return points;
}

}  // namespace quadrille
