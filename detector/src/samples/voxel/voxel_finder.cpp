#include "samples/voxel/voxel_finder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/lanes.hpp"

namespace quadrille {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
using Lanes = LanesOf<float>::Type;
using Masks __attribute__((vector_size(kLanes * sizeof(float)), may_alias)) = int;
using Halves __attribute__((vector_size(kLanes * sizeof(float)), may_alias)) = long long;

struct alignas(32) Ball {
  float px, py, pz;
  /// Squared radius of the ball, and squared radius within which voxels count as near.
  float square, near;
  /// Sums of 1, x, y, z, xx, yy, zz, xy, yz and zx.
  float sum[10];
};

/// Eight floats at any alignment.
using Loose __attribute__((vector_size(kLanes * sizeof(float)), aligned(4), may_alias)) = float;

QUADRILLE_INTO_CLONES void clear_outside(const Masks& in, Lanes& values) {
  values = reinterpret_cast<Lanes>(in & reinterpret_cast<Masks>(values));
}

/// Computes the sums over the ball, the squared distances of all voxels, the starts of the runs
/// that contain near voxels, and bit masks of these.
/// @return number of such runs
QUADRILLE_VECTOR_CLONES
int sum_ball(const float* x, const float* y, const float* z, int size, Ball* ball, float* distance,
             int* run, unsigned* bits) {
  const Ball b = *ball;
  const Masks weight = {1, 2, 4, 8, 16, 32, 64, 128};
  Masks n = {};
  Lanes sx = {}, sy = {}, sz = {}, xx = {}, yy = {}, zz = {}, xy = {}, yz = {}, zx = {};
  int runs = 0;
  for (int k = 0; k < size; k += kLanes) {
    Lanes dx = reinterpret_cast<const Loose&>(x[k]) - b.px;
    Lanes dy = reinterpret_cast<const Loose&>(y[k]) - b.py;
    Lanes dz = reinterpret_cast<const Loose&>(z[k]) - b.pz;
    const Lanes square = dx * dx + dy * dy + dz * dz;
    reinterpret_cast<Loose&>(distance[k]) = square;
    const Masks in = square <= b.square;
    const Halves near = reinterpret_cast<Halves>((square <= b.near) & weight);
    const unsigned long long two = (near[0] | near[1]) | (near[2] | near[3]);
    run[runs] = k;
    bits[runs] = static_cast<unsigned>(two | two >> 32);
    runs += two != 0;
    n -= in;
    clear_outside(in, dx), clear_outside(in, dy), clear_outside(in, dz);
    sx += dx, sy += dy, sz += dz;
    xx += dx * dx, yy += dy * dy, zz += dz * dz;
    xy += dx * dy, yz += dy * dz, zx += dz * dx;
  }
  const Lanes sums[10] = {__builtin_convertvector(n, Lanes), sx, sy, sz, xx, yy, zz, xy, yz, zx};
  for (int k = 0; k < 10; ++k) ball->sum[k] = static_cast<float>(sum_of_lanes(sums[k]));
  return runs;
}

/// One or zero, computed without a branch.
inline std::size_t is_between(float x, float low, float high) {
  return std::size_t{x >= low} & std::size_t{x <= high};
}

/// For each value, counts the values that are smaller.
QUADRILLE_VECTOR_CLONES
void rank_all(const float* values, int size, int* rank) {
  for (int k = 0; k < size; k += kLanes) {
    const Lanes own = reinterpret_cast<const Loose&>(values[k]);
    Masks smaller = {};
    for (int i = 0; i < size; ++i) smaller -= own > values[i];
    __builtin_memcpy(rank + k, &smaller, sizeof(smaller));
  }
}

}  // namespace

VoxelFinder::VoxelFinder(const VoxelGrid& grid, float radius, std::span<const char> keep)
    : grid_(grid),
      keep_(keep),
      radius_(radius),
      reach_(static_cast<int>(std::min(static_cast<float>(VoxelGrid::kMaxCoordinate),
                                       std::ceil(radius / (4 * grid.edge()))))),
      home_(VoxelGrid::kNoKey) {}

void VoxelFinder::find_bricks(int x, int y, int z) {
  bricks_.clear();
  const double side = 2.0 * reach_ + 1.0;
  if (side * side * side > static_cast<double>(grid_.bricks_.size())) {
    find_among_all(x, y, z);
    return;
  }
  for (int k = std::max(0, z - reach_); k <= z + reach_; ++k) {
    for (int j = std::max(0, y - reach_); j <= y + reach_; ++j) {
      for (int i = std::max(0, x - reach_); i <= x + reach_; ++i) {
        const VoxelGrid::Brick* const brick = grid_.find(VoxelGrid::key_of(i, j, k));
        if (brick) bricks_.push_back(brick);
      }
    }
  }
}

/// For a wide ball, testing every existing brick is cheaper than looking up each possible one.
void VoxelFinder::find_among_all(int x, int y, int z) {
  const auto is_near = [&](std::uint64_t key, int shift, int centre) {
    return std::abs(static_cast<int>(key >> shift & 0x1fffff) - centre) <= reach_;
  };
  for (const VoxelGrid::Brick& brick : grid_.bricks_) {
    if (is_near(brick.key, 0, x) && is_near(brick.key, 21, y) && is_near(brick.key, 42, z)) {
      bricks_.push_back(&brick);
    }
  }
  std::sort(bricks_.begin(), bricks_.end(),
            [](const auto* a, const auto* b) { return a->first < b->first; });
}

void VoxelFinder::gather_around(const Eigen::Vector3f& p) {
  const int x = static_cast<int>(grid_.coordinate(p.x()) / 4);
  const int y = static_cast<int>(grid_.coordinate(p.y()) / 4);
  const int z = static_cast<int>(grid_.coordinate(p.z()) / 4);
  const std::uint64_t home = VoxelGrid::key_of(x, y, z);
  if (home == home_) return;
  home_ = home;
  find_bricks(x, y, z);
  std::size_t max_size = kLanes;
  for (const VoxelGrid::Brick* brick : bricks_) max_size += static_cast<std::size_t>(brick->size);
  voxel_.resize(max_size);
  for (std::vector<float>* axis : {&x_, &y_, &z_}) axis->resize(max_size);
  const Eigen::AlignedBox3f box = grid_.box_of_brick(x, y, z, radius_);
  const Eigen::Vector3f &low = box.min(), &high = box.max();
  // Each voxel is written, and kept by advancing n only if it counts, without a branch.
  std::size_t n = 0;
  for (const VoxelGrid::Brick* brick : bricks_) {
    for (int v = brick->first; v < brick->first + brick->size; ++v) {
      const Eigen::Vector3f& mean = grid_.mean_[v];
      voxel_[n] = v, x_[n] = mean.x(), y_[n] = mean.y(), z_[n] = mean.z();
      n += std::size_t{keep_.empty() || keep_[v]} & is_between(mean.x(), low.x(), high.x()) &
           is_between(mean.y(), low.y(), high.y()) & is_between(mean.z(), low.z(), high.z());
    }
  }
  const std::size_t padded = (n + kLanes - 1) / kLanes * kLanes;
  voxel_.resize(n);
  for (std::vector<float>* axis : {&x_, &y_, &z_}) {
    std::fill(axis->begin() + static_cast<std::ptrdiff_t>(n),
              axis->begin() + static_cast<std::ptrdiff_t>(padded), kInfinity);
    axis->resize(padded);
  }
  distance_.resize(padded);
  run_.resize(padded / kLanes + 1);
  bits_.resize(run_.size());
}

const std::vector<int>& VoxelFinder::within(const Eigen::Vector3f& p) {
  gather_around(p);
  within_.resize(voxel_.size() + 1);
  std::size_t found = 0;
  for (std::size_t k = 0; k < voxel_.size(); ++k) {
    const float dx = x_[k] - p.x(), dy = y_[k] - p.y(), dz = z_[k] - p.z();
    within_[found] = voxel_[k];
    found += dx * dx + dy * dy + dz * dz <= radius_ * radius_;
  }
  within_.resize(found);
  return within_;
}

/// Collects the near voxels of the runs.
/// @return their number
int VoxelFinder::collect_near(int runs) {
  const std::size_t room = static_cast<std::size_t>(runs + 1) * kLanes;
  if (room > rank_.size())
    near_distance_.resize(room), near_voxel_.resize(room), rank_.resize(room);
  int found = 0;
  for (int r = 0; r < runs; ++r) {
    for (unsigned bits = bits_[r]; bits; bits &= bits - 1) {
      const int k = run_[r] + std::countr_zero(bits);
      near_distance_[found] = distance_[k];
      near_voxel_[found++] = voxel_[k];
    }
  }
  std::fill_n(near_distance_.begin() + found, kLanes, kInfinity);
  return found;
}

PlaneMoments VoxelFinder::moments(const Eigen::Vector3f& p, float reach, int max_count,
                                  std::vector<int>* nearest) {
  gather_around(p);
  Ball ball{p.x(), p.y(), p.z(), radius_ * radius_, reach * reach, {}};
  const int runs = sum_ball(x_.data(), y_.data(), z_.data(), static_cast<int>(x_.size()), &ball,
                            distance_.data(), run_.data(), bits_.data());
  const int near = collect_near(runs);
  rank_all(near_distance_.data(), near, rank_.data());
  // Equally near voxels share a rank, so there may be more of the last rank than there is room for.
  int last = -1, nearer = 0;
  for (int k = 0; k < near; ++k) {
    if (rank_[k] < max_count) last = std::max(last, rank_[k]);
  }
  for (int k = 0; k < near; ++k) nearer += rank_[k] < last;
  int left = max_count - nearer;
  nearest->clear();
  for (int k = 0; k < near; ++k) {
    if (rank_[k] < last || (rank_[k] == last && left-- > 0)) nearest->push_back(near_voxel_[k]);
  }
  const float* s = ball.sum;
  return {s[0], {s[1], s[2], s[3]}, {s[4], s[5], s[6]}, {s[7], s[8], s[9]}};
}

}  // namespace quadrille
