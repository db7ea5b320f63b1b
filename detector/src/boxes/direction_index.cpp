#include "boxes/direction_index.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/vector_clones.hpp"
#include "cloud/look_at.hpp"

namespace quadrille {
namespace {

// Number of points in the tile of a full image, a quarter of which make the next thinner level.
constexpr double kPointsPerTile = 4.0;
// Least side of the image as a tangent, so that an image that is only a line has an area.
constexpr float kMinTangent = 1e-3f;

/// A grid of tiles over an image.
struct TileGrid {
  float u0, v0, per_unit;
  int width, last_i, last_j;
};

/// Looks at points and finds their tiles, −1 for unseen points. No point lies left of or above the
/// image.
/// @param first  number of the first of kSize points
QUADRILLE_VECTOR_CLONES
void find_tiles(const PinholeView& view, std::span<const Eigen::Vector3f> points, std::size_t first,
                TileGrid grid, int* tile) {
  const SeenPoints t = look_at(view, points, first);
  for (int k = 0; k < SeenPoints::kSize; ++k) {
    const int i = std::min(static_cast<int>((t.u[k] - grid.u0) * grid.per_unit), grid.last_i);
    const int j = std::min(static_cast<int>((t.v[k] - grid.v0) * grid.per_unit), grid.last_j);
    // A choice between the two would keep the compiler from vectorising the conversions to int.
    const int unseen = -static_cast<int>(!(t.w[k] > 0.0f));
    tile[k] = (j * grid.width + i) | unseen;
  }
}

}  // namespace

DirectionIndex::DirectionIndex(const CloudView& cloud, const std::optional<PinholeView>& view)
    : cloud_(cloud), view_(view) {
  if (!view_) return;
  constexpr std::size_t kSize = SeenPoints::kSize;
  const Eigen::Array2f size = view_->bounds.sizes().array().max(kMinTangent);
  const double tiles = std::max(1.0, static_cast<double>(view_->seen) / kPointsPerTile);
  per_unit_ = static_cast<float>(std::sqrt(tiles / static_cast<double>(size.prod())));
  width_ = 1 + static_cast<int>(size.x() * per_unit_);
  height_ = 1 + static_cast<int>(size.y() * per_unit_);
  const Eigen::Vector2f& corner = view_->bounds.min();
  const TileGrid grid{corner.x(), corner.y(), per_unit_, width_, width_ - 1, height_ - 1};
  const std::size_t looked = (cloud.points.size() + kSize - 1) / kSize * kSize;
  // The loop below sets each element, so they need not be set to 0 before.
  const auto tile = std::make_unique_for_overwrite<int[]>(looked);
  for (std::size_t first = 0; first < looked; first += kSize) {
    find_tiles(*view_, cloud.points, first, grid, tile.get() + first);
  }
  tiles_ = sort_into_buckets({tile.get(), looked}, width_ * height_);
}

Eigen::Vector2i DirectionIndex::tile_of(const Eigen::Vector2f& tangents) const {
  const Eigen::Array2f place = (tangents - view_->bounds.min()).array() * per_unit_;
  const Eigen::Array2f last(static_cast<float>(width_ - 1), static_cast<float>(height_ - 1));
  return place.max(0.0f).min(last).cast<int>();
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
    std::span<const Eigen::Vector3d> places_C, double margin, std::size_t max_points) const {
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
  const Tiles tiles{tile_of(image.min()), tile_of(image.max())};
  std::size_t count = 0;
  for (int row = tiles.low.y(); row <= tiles.high.y(); ++row) {
    count += points_in(row, tiles.low.x(), tiles.high.x()).size();
  }
  int side = 0;
  for (std::size_t left = count; left > max_points; left /= 4) side = std::max(1, 2 * side);
  if (side > 0) return thinned(tiles, side);
  std::vector<Eigen::Vector3d> points;
  points.reserve(count);
  for (int row = tiles.low.y(); row <= tiles.high.y(); ++row) {
    for (const int k : points_in(row, tiles.low.x(), tiles.high.x())) {
      points.push_back(cloud_.points[k].cast<double>());
    }
  }
  return points;
}

std::span<const int> DirectionIndex::points_in(int row, int from, int to) const {
  const int* const first = tiles_.first.data() + std::ptrdiff_t{row} * width_;
  return {tiles_.list.data() + first[from], static_cast<std::size_t>(first[to + 1] - first[from])};
}

std::vector<Eigen::Vector3d> DirectionIndex::thinned(const Tiles& tiles, int side) const {
  const Eigen::Vector2i low = tiles.low / side, high = tiles.high / side;
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>((high - low + Eigen::Vector2i::Ones()).prod()));
  const int *const first = tiles_.first.data(), *const list = tiles_.list.data();
  for (int j = low.y(); j <= high.y(); ++j) {
    const int end = std::min((j + 1) * side, height_) * width_;
    for (int i = low.x(); i <= high.x(); ++i) {
      const int to = std::min((i + 1) * side, width_), tiles_in_row = to - i * side;
      for (int tile = j * side * width_ + i * side; tile < end; tile += width_) {
        if (first[tile] == first[tile + tiles_in_row]) continue;
        points.push_back(cloud_.points.data()[list[first[tile]]].cast<double>());
        break;
      }
    }
  }
  return points;
}

}  // namespace quadrille
