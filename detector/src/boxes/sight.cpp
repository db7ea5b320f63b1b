#include "boxes/sight.hpp"

#include <algorithm>
#include <numeric>

namespace quadrille {
namespace {

// Tiles along either side of the image.
constexpr int kTiles = 64;

}  // namespace

Sight::Sight(const PointCloud& cloud) : cloud_(&cloud), view_(find_view(cloud)) {
  if (!view_) return;
  std::vector<int> tile(cloud.points.size(), -1);
  begin_.assign(kTiles * kTiles + 1, 0);
  for (std::size_t k = 0; k < tile.size(); ++k) {
    const Eigen::Vector3f seen = (*view_)(cloud.points[k]);
    if (!(seen.z() > 0.0f)) continue;
    const Eigen::Vector2i at = tile_of(seen.head<2>());
    tile[k] = at.y() * kTiles + at.x();
    ++begin_[static_cast<std::size_t>(tile[k]) + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  order_.resize(static_cast<std::size_t>(begin_.back()));
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t k = 0; k < tile.size(); ++k) {
    if (tile[k] >= 0) order_[next[tile[k]]++] = static_cast<int>(k);
  }
}

Eigen::Vector2i Sight::tile_of(const Eigen::Vector2f& tangents) const {
  const Eigen::Array2f size = view_->bounds.sizes().array().max(1e-6f);
  const Eigen::Array2f place = (tangents - view_->bounds.min()).array() / size * kTiles;
  return place.max(0.0f).min(kTiles - 1.0f).cast<int>();
}

std::vector<Eigen::Vector3d> Sight::points_within(const Eigen::AlignedBox3d& bounds_C) const {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& p : cloud_->points) {
    if (bounds_C.contains(p.cast<double>())) points.push_back(p.cast<double>());
  }
  return points;
}

std::vector<Eigen::Vector3d> Sight::points_towards(std::span<const Eigen::Vector3d> places_C,
                                                   double margin) const {
  Eigen::AlignedBox3d bounds_C;
  for (const Eigen::Vector3d& p : places_C) bounds_C.extend(p);
  bounds_C.min().array() -= margin;
  bounds_C.max().array() += margin;
  if (!view_) return points_within(bounds_C);
  Eigen::AlignedBox2f image;
  for (const Eigen::Vector3d& p : places_C) {
    const Eigen::Vector3f seen = (*view_)(p.cast<float>());
    if (!(seen.z() > 0.0f)) return points_within(bounds_C);
    const float step = static_cast<float>(margin) * seen.z();
    image.extend(Eigen::Vector2f(seen.head<2>().array() - step));
    image.extend(Eigen::Vector2f(seen.head<2>().array() + step));
  }
  const Eigen::Vector2i low = tile_of(image.min()), high = tile_of(image.max());
  std::vector<Eigen::Vector3d> points;
  for (int row = low.y(); row <= high.y(); ++row) {
    const int first = begin_[row * kTiles + low.x()], last = begin_[row * kTiles + high.x() + 1];
    for (int k = first; k < last; ++k) points.push_back(cloud_->points[order_[k]].cast<double>());
  }
  return points;
}

}  // namespace quadrille
