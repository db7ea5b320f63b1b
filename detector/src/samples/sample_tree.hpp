#pragma once

#include <span>
#include <vector>

#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// The samples of all levels, and the finest samples that lie under each coarser one.
class SampleTree {
 public:
  SampleTree(const CellPyramid& pyramid, std::vector<SurfaceSamples> levels);

  const SurfaceSamples& level(int l) const { return levels_[l]; }
  /// The finest samples under sample i of level l.
  std::span<const int> under(int l, int i) const;
  /// The finest samples with steadier normals: the mean of their own and their parent's.
  const SurfaceSamples& finest() const { return finest_; }

 private:
  std::vector<SurfaceSamples> levels_;
  SurfaceSamples finest_;
  /// Per level, first[i] … first[i + 1] - 1 are the positions in the list of the samples under
  /// sample i.
  std::vector<std::vector<int>> first_, list_;
};

}  // namespace quadrille
