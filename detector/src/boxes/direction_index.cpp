#include "boxes/direction_index.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace quadrille {
namespace {

// Number of tiles along each side of the image.
constexpr int kTiles = 64;
// This many points suffice to judge a face; for larger areas a thinner level is used.
constexpr std::size_t kMaxPoints = 12'000;

/// A grid over an image that admits the first point in each cell.
class Thinning {
 public:
  /// @param cells  approximate number of cells in the image
  Thinning(const Eigen::AlignedBox2f& image, double cells) : corner_(image.min()) {
    const Eigen::Array2f size = image.sizes().array().max(kMinTangent);
    per_unit_ = static_cast<float>(std::sqrt(cells / static_cast<double>(size.prod())));
    width_ = 1 + static_cast<std::size_t>(size.x() * per_unit_);
    taken_.assign(width_ * (1 + static_cast<std::size_t>(size.y() * per_unit_)), 0);
  }

  bool take(const Eigen::Vector2f& tangents) {
    const Eigen::Array2f at = (tangents - corner_).array() * per_unit_;
    const auto x = static_cast<std::size_t>(at.x()), y = static_cast<std::size_t>(at.y());
    return !std::exchange(taken_[y * width_ + x], 1);
  }

 private:
  // Least side of the image, so that an image that is only a line has an area.
  static constexpr float kMinTangent = 1e-3f;

  Eigen::Vector2f corner_;
  float per_unit_;
  std::size_t width_;
  std::vector<char> taken_;
};

}  // namespace

DirectionIndex::DirectionIndex(const CloudView& cloud) : cloud_(cloud), view_(find_view(cloud)) {
  if (!view_) return;
  std::vector<int> tile(cloud.points.size(), -1);
  std::vector<Eigen::Vector2f> tangents(cloud.points.size());
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    const Eigen::Vector3f seen = (*view_)(cloud.points[k]);
    if (!(seen.z() > 0.0f)) continue;
    tangents[k] = seen.head<2>();
    const Eigen::Vector2i at = tile_of(tangents[k]);
    tile[k] = at.y() * kTiles + at.x();
  }
  levels_.push_back(sort_into_buckets(tile, kTiles * kTiles));
  double cells = static_cast<double>(levels_.front().list.size());
  while (levels_.back().list.size() > kMaxPoints) {
    cells *= 0.25;
    levels_.push_back(thinned(levels_.back(), tangents, cells));
  }
}

Buckets DirectionIndex::thinned(const Buckets& level, const std::vector<Eigen::Vector2f>& tangents,
                                double cells) const {
  Thinning thinning(view_->bounds, cells);
  Buckets rest{{0}, {}};
  for (int tile = 0; tile < level.size(); ++tile) {
    std::copy_if(level[tile].begin(), level[tile].end(), std::back_inserter(rest.list),
                 [&](int k) { return thinning.take(tangents[k]); });
    rest.first.push_back(static_cast<int>(rest.list.size()));
  }
  return rest;
}

Eigen::Vector2i DirectionIndex::tile_of(const Eigen::Vector2f& tangents) const {
  const Eigen::Array2f size = view_->bounds.sizes().array().max(1e-6f);
  const Eigen::Array2f place = (tangents - view_->bounds.min()).array() / size * kTiles;
  return place.max(0.0f).min(kTiles - 1.0f).cast<int>();
}

std::vector<Eigen::Vector3d> DirectionIndex::points_within(
    const Eigen::AlignedBox3d& bounds_C) const {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& p : cloud_.points) {
    if (bounds_C.contains(p.cast<double>())) points.push_back(p.cast<double>());
  }
  return points;
}

std::vector<Eigen::Vector3d> DirectionIndex::points_towards(
    std::span<const Eigen::Vector3d> places_C, double margin) const {
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
  return points_in(tile_of(image.min()), tile_of(image.max()));
}

std::vector<Eigen::Vector3d> DirectionIndex::points_in(const Eigen::Vector2i& low,
                                                       const Eigen::Vector2i& high) const {
  const auto row_of = [&](const Buckets& level, int row) {
    const auto at = level.first.begin() + std::ptrdiff_t{row} * kTiles;
    return std::span(level.list).subspan(at[low.x()], at[high.x() + 1] - at[low.x()]);
  };
  const auto is_enough = [&](const Buckets& level) {
    std::size_t count = 0;
    for (int row = low.y(); row <= high.y(); ++row) count += row_of(level, row).size();
    return count <= kMaxPoints;
  };
  const Buckets& level = *std::find_if(levels_.begin(), levels_.end(), is_enough);
  std::vector<Eigen::Vector3d> points;
  for (int row = low.y(); row <= high.y(); ++row) {
    for (const int k : row_of(level, row)) points.push_back(cloud_.points[k].cast<double>());
  }
  return points;
}

}  // namespace quadrille
