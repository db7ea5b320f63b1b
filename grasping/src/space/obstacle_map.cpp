#include "space/obstacle_map.hpp"

#include <algorithm>
#include <cmath>

#include "space/space_on_demand.hpp"

namespace quadrille {
namespace {

/// Merges cubes of one level into a row of cubes of the next, each from eight. The first two flags
/// are set if any of the eight has them, the last if all have it. `fine` is the first of the four
/// rows of smaller cubes; `row` and `layer` are the distances to the others.
void merge(const std::uint8_t* __restrict fine, std::size_t row, std::size_t layer, int count,
           std::uint8_t* __restrict coarse) {
  const std::uint8_t *a = fine, *b = fine + row, *c = fine + layer, *d = fine + layer + row;
  for (int i = 0; i < count; ++i) {
    const int even = 2 * i, odd = even + 1;
    const int any = a[even] | a[odd] | b[even] | b[odd] | c[even] | c[odd] | d[even] | d[odd];
    const int all = a[even] & a[odd] & b[even] & b[odd] & c[even] & c[odd] & d[even] & d[odd];
    coarse[i] = static_cast<std::uint8_t>((any & 3) | (all & 4));
  }
}

}  // namespace

void ObstacleMap::Block::refresh() {
  for (int n = 1; n < kLevels; ++n) {
    const int edge = kEdge >> n;
    const auto row = 2 * static_cast<std::size_t>(edge);
    for (int k = 0; k < edge; ++k) {
      for (int j = 0; j < edge; ++j) {
        merge(this->row(n - 1, 2 * j, 2 * k), row, row * row, edge, this->row(n, j, k));
      }
    }
  }
}

ObstacleMap::ObstacleMap(const OccupancyGrid& grid, bool unknown_blocks,
                         std::span<const DepthView> views, bool divide_occupied)
    : resolution_(grid.resolution()),
      unknown_blocks_(unknown_blocks),
      divide_occupied_(divide_occupied && views.size() == 1),
      views_(views),
      corner_(grid.corner().cast<double>() * grid.resolution()),
      size_(grid.size()),
      numbers_((grid.size() / kEdge).cast<std::size_t>().prod(), -1) {
  if (numbers_.empty()) return;
  // Only unknown voxels need more than those that hold points.
  if (grid.source_ && !unknown_blocks) {
    add_occupied(grid);
  } else {
    add_all(grid);
  }
}

/// Adds a block, given by its first voxel and the flags of its voxels, unless it is empty.
void ObstacleMap::add(const Eigen::Vector3i& first, const Block& block) {
  blocks_.push_back(block);
  blocks_.back().refresh();
  if (blocks_.back().is_empty()) {
    blocks_.pop_back();
  } else {
    numbers_[block_index(first)] = static_cast<int>(blocks_.size()) - 1;
  }
}

void ObstacleMap::add_all(const OccupancyGrid& grid) {
  const std::uint8_t unknown = unknown_blocks_ ? kAnyUnknown | kAll : 0;
  const std::uint8_t occupied = kAnyOccupied | kAll;
  const Voxel* states = grid.states().data();
  each_cube(Eigen::Vector3i::Zero(), size_, kEdge, [&](const Eigen::Vector3i& first) {
    Block block;
    for (int k = 0; k < kEdge; ++k) {
      for (int j = 0; j < kEdge; ++j) {
        const Voxel* row = states + grid.index(first.x(), first.y() + j, first.z() + k);
        std::transform(row, row + kEdge, block.row(0, j, k), [=](Voxel state) -> std::uint8_t {
          return state == Voxel::kUnknown ? unknown : state == Voxel::kOccupied ? occupied : 0;
        });
      }
    }
    add(first, block);
  });
}

void ObstacleMap::add_occupied(const OccupancyGrid& grid) {
  const SpaceMapper& voxels = grid.source_->occupied();
  for (const Eigen::Vector3i& first : voxels.occupied_blocks()) {
    Block block;
    for (int k = 0; k < kEdge; ++k) {
      for (int j = 0; j < kEdge; ++j) {
        const Voxel* row = &voxels.voxel(first.x(), first.y() + j, first.z() + k);
        std::uint8_t* flags = block.row(0, j, k);
        for (int i = 0; i < kEdge; ++i) {
          flags[i] = row[i] == Voxel::kOccupied ? kAnyOccupied | kAll : 0;
        }
      }
    }
    add(first, block);
  }
}

bool ObstacleMap::is_occupied(const Eigen::Vector3d& p_C) const {
  // Voxels are counted as OccupancyGrid::at() counts them.
  const Eigen::Array3d x =
      (p_C / resolution_).array().floor() - (corner_ / resolution_).array().round();
  if (!((x >= 0.0).all() && (x < size_.cast<double>().array()).all())) return false;
  const Eigen::Vector3i voxel = x.cast<int>(),
                        in_block = voxel.unaryExpr([](int at) { return at % kEdge; });
  const Block* block = block_of(voxel);
  return block != nullptr &&
         (block->row(0, in_block.y(), in_block.z())[in_block.x()] & kAnyOccupied) != 0;
}

ObstacleMap ObstacleMap::within(const Eigen::AlignedBox3d& region) const {
  const Range range = voxels(region);
  ObstacleMap map;
  map.resolution_ = resolution_;
  map.unknown_blocks_ = unknown_blocks_;
  map.divide_occupied_ = divide_occupied_;
  map.views_ = views_;
  const Eigen::Vector3i low = range.first / kEdge * kEdge;
  map.size_ = ((range.second.array() + kEdge) / kEdge * kEdge).matrix() - low;
  map.corner_ = corner_ + resolution_ * low.cast<double>();
  map.numbers_.assign((map.size_ / kEdge).cast<std::size_t>().prod(), -1);
  each_cube(low, low + map.size_, kEdge, [&](const Eigen::Vector3i& first) {
    const Block* block = block_of(first);
    // Most blocks hold nothing.
    if (block == nullptr) return;
    map.numbers_[map.block_index(first - low)] = static_cast<int>(map.blocks_.size());
    map.blocks_.push_back(*block);
  });
  return map;
}

void ObstacleMap::refresh(const Range& range) {
  // The cube that was met last may be among those that changed.
  last_ = {};
  if ((range.second.array() < 0).any()) return;
  each_cube(range.first / kEdge * kEdge, range.second.array() + 1, kEdge,
            [&](const Eigen::Vector3i& first) {
              if (Block* block = block_of(first)) block->refresh();
            });
}

ObstacleMap::Range ObstacleMap::voxels(const Eigen::AlignedBox3d& box) const {
  const Eigen::Array3d last = size_.cast<double>().array() - 1.0;
  const auto clip = [&](const Eigen::Vector3d& p) {
    const Eigen::Array3d x = ((p - corner_) / resolution_).array().floor();
    return Eigen::Vector3i(x.max(0.0).min(last).cast<int>());
  };
  // A box that lies beside the grid gives an empty range.
  const Eigen::Vector3d top = corner_ + resolution_ * (last + 1.0).matrix();
  if ((last < 0.0).any() || !box.intersects(Eigen::AlignedBox3d(corner_, top))) {
    return {Eigen::Vector3i::Zero(), Eigen::Vector3i::Constant(-1)};
  }
  return {clip(box.min()), clip(box.max())};
}

}  // namespace quadrille
