#include "boxes/direction_index.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace quadrille {
namespace {

// Number of tiles along each side of the image.
constexpr int kTiles = 64;
// Number of levels; each has about a quarter of the points of the level before.
constexpr int kLevels = 4;
// This many points suffice to judge a face; for larger areas a thinner level is used.
constexpr int kMaxPoints = 12'000;

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
  SeenByTile seen = by_tile(cloud.points);
  double cells = static_cast<double>(seen.level.points.size());
  levels_.push_back(seen.level);
  for (int n = 1; n < kLevels; ++n) {
    cells *= 0.25;
    thin(view_->bounds, cells, &seen);
    levels_.push_back(seen.level);
  }
}

DirectionIndex::SeenByTile DirectionIndex::by_tile(std::span<const Eigen::Vector3f> points) const {
  constexpr int kUnseen = -1;
  std::vector<int> tile(points.size(), kUnseen);
  std::vector<Eigen::Vector2f> tangents(points.size());
  SeenByTile seen;
  std::vector<int>& begin = seen.level.begin;
  begin.assign(kTiles * kTiles + 1, 0);
  for (std::size_t first = 0; first < points.size(); first += SeenPoints::kSize) {
    const SeenPoints block = view_->look(points, first);
    const std::size_t size = std::min<std::size_t>(SeenPoints::kSize, points.size() - first);
    for (std::size_t i = 0; i < size; ++i) {
      if (!(block.w[i] > 0.0f)) continue;
      tangents[first + i] = {block.u[i], block.v[i]};
      const Eigen::Vector2i at = tile_of(tangents[first + i]);
      tile[first + i] = at.y() * kTiles + at.x();
      ++begin[static_cast<std::size_t>(tile[first + i]) + 1];
    }
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  seen.level.points.resize(static_cast<std::size_t>(begin.back()));
  seen.tangents.resize(seen.level.points.size());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (tile[k] == kUnseen) continue;
    const int place = next[tile[k]]++;
    seen.level.points[place] = static_cast<int>(k);
    seen.tangents[place] = tangents[k];
  }
  return seen;
}

void DirectionIndex::thin(const Eigen::AlignedBox2f& image, double cells, SeenByTile* seen) {
  Thinning thinning(image, cells);
  std::vector<int>& begin = seen->level.begin;
  int kept = 0;
  for (std::size_t tile = 0; tile + 1 < begin.size(); ++tile) {
    const int first = std::exchange(begin[tile], kept);
    for (int k = first; k < begin[tile + 1]; ++k) {
      if (!thinning.take(seen->tangents[k])) continue;
      seen->level.points[kept] = seen->level.points[k];
      seen->tangents[kept++] = seen->tangents[k];
    }
  }
  begin.back() = kept;
  seen->level.points.resize(static_cast<std::size_t>(kept));
  seen->tangents.resize(static_cast<std::size_t>(kept));
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
  const auto first = [&](const Level& level, int row) {
    return level.begin[row * kTiles + low.x()];
  };
  const auto last = [&](const Level& level, int row) {
    return level.begin[row * kTiles + high.x() + 1];
  };
  const auto is_enough = [&](const Level& level) {
    int count = 0;
    for (int row = low.y(); row <= high.y(); ++row) count += last(level, row) - first(level, row);
    return count <= kMaxPoints;
  };
  const auto found = std::find_if(levels_.begin(), levels_.end(), is_enough);
  const Level& level = found == levels_.end() ? levels_.back() : *found;
  std::vector<Eigen::Vector3d> points;
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int k = first(level, row); k < last(level, row); ++k) {
      points.push_back(cloud_.points[level.points[k]].cast<double>());
    }
  }
  return points;
}

}  // namespace quadrille
