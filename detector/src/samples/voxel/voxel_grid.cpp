#include "samples/voxel/voxel_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {
namespace {

// Share of a voxel by which rounding may move a point across a face.
constexpr double kRoundingShare = 0.01;

/// Faster than testing each coordinate: x − x is zero unless x is infinite or NaN.
bool is_finite(const Eigen::Vector3f& p) {
  return (p.x() - p.x()) + (p.y() - p.y()) + (p.z() - p.z()) == 0.0f;
}

/// Like std::popcount, which is a function call on machines without such an instruction.
int count_bits(std::uint64_t bits) {
  bits -= bits >> 1 & 0x5555555555555555;
  bits = (bits & 0x3333333333333333) + (bits >> 2 & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<int>(bits * 0x0101010101010101 >> 56);
}

/// Spreads the lowest 21 bits, with two zeros after each.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Position of a brick on the Morton curve, along which neighbours in space are mostly near each
/// other.
std::uint64_t curve_of(std::uint64_t key) {
  return spread_bits(key) | spread_bits(key >> 21) << 1 | spread_bits(key >> 42) << 2;
}

}  // namespace

int VoxelGrid::Brick::voxel(int bit) const {
  return first + count_bits(filled & ((std::uint64_t{1} << bit) - 1));
}

int VoxelGrid::voxel_of(const Eigen::Vector3f& point) const {
  if (!is_finite(point)) return -1;
  const Place place = place_of(point);
  const Brick* brick = find(place.key);
  return brick && brick->filled >> place.bit & 1 ? brick->voxel(place.bit) : -1;
}

void VoxelGrid::rehash(std::size_t slots) {
  slots_.assign(slots, -1);
  for (std::size_t b = 0; b < bricks_.size(); ++b) {
    std::size_t slot = slot_of(bricks_[b].key);
    while (slots_[slot] >= 0) slot = (slot + 1) & (slots - 1);
    slots_[slot] = static_cast<int>(b);
  }
}

const VoxelGrid::Brick* VoxelGrid::find(std::uint64_t key) const {
  for (std::size_t slot = slot_of(key); slots_[slot] >= 0;
       slot = (slot + 1) & (slots_.size() - 1)) {
    if (bricks_[slots_[slot]].key == key) return &bricks_[slots_[slot]];
  }
  return nullptr;
}

Eigen::AlignedBox3f VoxelGrid::box_of_brick(int bx, int by, int bz, float margin) const {
  const Eigen::Vector3d first =
      Eigen::Vector3d(bx, by, bz) * 4.0 - Eigen::Vector3d::Constant(kMaxCoordinate);
  const double edge = edge_;
  const Eigen::Vector3d wider = Eigen::Vector3d::Constant(margin + kRoundingShare * edge);
  return {
      Eigen::Vector3f((first * edge - wider).cast<float>()),
      Eigen::Vector3f(((first.array() + 4.0) * edge).matrix().cast<float>() + wider.cast<float>())};
}

int VoxelGrid::find_or_add(std::uint64_t key) {
  std::size_t slot = slot_of(key);
  for (; slots_[slot] >= 0; slot = (slot + 1) & (slots_.size() - 1)) {
    if (bricks_[slots_[slot]].key == key) return slots_[slot];
  }
  const int brick = static_cast<int>(bricks_.size());
  slots_[slot] = brick;
  bricks_.push_back({key, 0, 0, 0});
  if (2 * bricks_.size() > slots_.size()) rehash(2 * slots_.size());
  return brick;
}

int VoxelGrid::number_voxels() {
  std::vector<std::pair<std::uint64_t, int>> order;
  order.reserve(bricks_.size());
  for (std::size_t b = 0; b < bricks_.size(); ++b) {
    order.emplace_back(curve_of(bricks_[b].key), static_cast<int>(b));
  }
  std::sort(order.begin(), order.end());
  int size = 0;
  for (const auto& [place, b] : order) {
    bricks_[b].first = size;
    bricks_[b].size = count_bits(bricks_[b].filled);
    size += bricks_[b].size;
  }
  return size;
}

VoxelGrid::VoxelGrid(std::span<const Eigen::Vector3f> points, std::span<const int> weight,
                     float edge, std::vector<int>* of_point)
    : edge_(edge), inverse_(1.0 / static_cast<double>(edge)), slots_(2, -1) {
  // For each point its brick, and later its voxel.
  std::vector<int> place(points.size(), -1);
  std::vector<unsigned char> bit(points.size());
  std::uint64_t last_key = kNoKey;
  int last = -1;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3f& p = points[k];
    if (!is_finite(p)) continue;
    const Place at = place_of(p);
    if (at.key != last_key) {
      last = find_or_add(at.key);
      last_key = at.key;
    }
    place[k] = last;
    bit[k] = static_cast<unsigned char>(at.bit);
    bricks_[last].filled |= std::uint64_t{1} << bit[k];
  }
  const int size = number_voxels();
  // Sums are in double precision, since a cloud may lie far from the origin.
  std::vector<Eigen::Vector3d> sum(static_cast<std::size_t>(size), Eigen::Vector3d::Zero());
  count_.assign(sum.size(), 0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (place[k] < 0) continue;
    const int v = place[k] = bricks_[place[k]].voxel(bit[k]);
    const int w = weight.empty() ? 1 : weight[k];
    sum[v] += w * points[k].cast<double>();
    count_[v] += w;
  }
  mean_.reserve(sum.size());
  for (std::size_t v = 0; v < sum.size(); ++v) mean_.push_back((sum[v] / count_[v]).cast<float>());
  if (of_point) *of_point = std::move(place);
}

}  // namespace quadrille
