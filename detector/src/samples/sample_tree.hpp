#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/buckets.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// The samples of all levels, and the finest samples that lie under each coarser one.
class SampleTree {
 public:
  SampleTree(const CellPyramid& pyramid, std::vector<SurfaceSamples> levels);

  const SurfaceSamples& level(int l) const { return levels_[l]; }
  /// The finest samples under sample i of level l.
  std::span<const int> under(int l, int i) const { return under_[l][i]; }
  /// The finest samples with steadier normals: the mean of their own and their parent's.
  const SurfaceSamples& finest() const { return finest_; }
  SurfaceSamples take_finest() && { return std::move(finest_); }

 private:
  std::vector<SurfaceSamples> levels_;
  SurfaceSamples finest_;
  /// Per level, the finest samples under each of its samples.
  std::vector<Buckets> under_;
};

}  // namespace quadrille
