#include "surfaces/evidence/sample_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "base/buckets.hpp"
#include "base/vector_clones.hpp"
#include "samples/voxel/voxel_grid.hpp"
#include "surfaces/evidence/box_test.hpp"

namespace quadrille {
namespace {

// Edge of a block in cells of a sample, so that a surface fills some dozens of blocks.
constexpr float kEdgeCells = 16.0f;
// Boxes are widened by this share of the coordinates, many times what rounding makes of them.
constexpr float kRounding = 1e-5f;
// Positions are tested in steps of this many, so rows are longer by as much.
constexpr int kStep = 32;

/// Finds those of the first `size` positions that lie in a box.
/// @param sample  number of the sample at each position
/// @param list    receives the samples inside; it must have room for all
/// @return the number of samples inside
QUADRILLE_VECTOR_CLONES
std::size_t find_inside(BoxTest test, int size, const float* x, const float* y, const float* z,
                        const int* sample, int* list) {
  std::size_t found = 0;
  for (int start = 0; start < size; start += kStep) {
    char inside[kStep];
    const int step = std::min(kStep, size - start);
    for (int k = 0; k < kStep; ++k) {
      inside[k] = static_cast<char>(test.holds(x[start + k], y[start + k], z[start + k]));
    }
    for (int k = 0; k < step; ++k) {
      list[found] = sample[start + k];
      found += static_cast<std::size_t>(inside[k]);
    }
  }
  return found;
}

}  // namespace

SampleTable::SampleTable(const SurfaceSamples& samples, std::span<const int> list)
    : size_(list.size()), stride_(list.size() + kStep), values_(8 * stride_) {
  float* const values = values_.data();
  for (std::size_t k = 0; k < size_; ++k) {
    const int i = list[k];
    const Eigen::Vector3f &p = samples.raw[i], &n = samples.n[i];
    const float of[] = {p.x(),          p.y(), p.z(), n.x(), n.y(), n.z(), samples.sigma[i],
                        samples.cell[i]};
    for (std::size_t row = 0; row < std::size(of); ++row) values[row * stride_ + k] = of[row];
  }
}

SampleRows SampleTable::rows(int first, int size) const {
  const auto row = [&](std::size_t k) { return values_.data() + k * stride_ + first; };
  return {size, row(0), row(1), row(2), row(3), row(4), row(5), row(6), row(7)};
}

SampleBlocks::SampleBlocks(const SurfaceSamples& samples) {
  if (samples.size() == 0) return;
  const float edge = kEdgeCells * samples.cell[static_cast<std::size_t>(samples.size()) / 2];
  std::vector<int> voxel;
  const VoxelGrid grid(samples.raw, {}, edge, &voxel);
  Buckets buckets = sort_into_buckets(voxel, grid.size());
  sample_ = std::move(buckets.list);
  table_ = SampleTable(samples, sample_);
  for (int b = 0; b < buckets.size(); ++b) {
    Block block{grid.mean()[b], 0.0f, buckets.first[b], buckets.first[b + 1] - buckets.first[b]};
    for (int k = block.first; k < block.first + block.size; ++k) {
      block.radius = std::max(block.radius, (samples.raw[sample_[k]] - block.centre).norm());
    }
    blocks_.push_back(block);
  }
}

std::vector<const SampleBlocks::Block*> SampleBlocks::blocks_near(
    const Eigen::Affine3f& X_BC, const Eigen::AlignedBox3f& box_B) const {
  const BoxTest test(X_BC, box_B, kRounding);
  const Eigen::Array3f low = Eigen::Array3f::Map(test.low), high = Eigen::Array3f::Map(test.high);
  const Eigen::Array3f stretch = (1.0f + kRounding) * X_BC.linear().rowwise().norm().array();
  std::vector<const Block*> near;
  for (const Block& block : blocks_) {
    const Eigen::Array3f c = (X_BC * block.centre).array(), r = block.radius * stretch;
    if (((c + r >= low) && (c - r <= high)).all()) near.push_back(&block);
  }
  return near;
}

std::vector<SampleRows> SampleBlocks::near_box(const Eigen::Affine3f& X_BC,
                                               const Eigen::AlignedBox3f& box_B) const {
  std::vector<SampleRows> rows;
  for (const Block* block : blocks_near(X_BC, box_B)) {
    rows.push_back(table_.rows(block->first, block->size));
  }
  return rows;
}

std::vector<int> SampleBlocks::in_box(const Eigen::Affine3f& X_BC,
                                      const Eigen::AlignedBox3f& box_B) const {
  const BoxTest test(X_BC, box_B, kRounding);
  const std::vector<const Block*> near = blocks_near(X_BC, box_B);
  std::size_t size = 0;
  for (const Block* block : near) size += static_cast<std::size_t>(block->size);
  std::vector<int> found(size);
  std::size_t length = 0;
  for (const Block* block : near) {
    const SampleRows rows = table_.rows(block->first, block->size);
    length += find_inside(test, rows.size, rows.x, rows.y, rows.z, &sample_[block->first],
                          &found[length]);
  }
  found.resize(length);
  return found;
}

}  // namespace quadrille
