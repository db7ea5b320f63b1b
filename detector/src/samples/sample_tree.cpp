#include "samples/sample_tree.hpp"

namespace quadrille {

SampleTree::SampleTree(const CellPyramid& pyramid, std::vector<SurfaceSamples> levels)
    : levels_(std::move(levels)), finest_(levels_[0]) {
  // The finest level is copied, since the search continues with that level's own normals. For each
  // finest sample, `cell` is the cell above it at the current level.
  std::vector<int> cell = levels_[0].source;
  for (int l = 0; l < kLevels; ++l) {
    std::vector<int> sample_of(static_cast<std::size_t>(pyramid.size(l)), -1);
    for (int i = 0; i < levels_[l].size(); ++i) sample_of[levels_[l].source[i]] = i;
    std::vector<int> above;
    above.reserve(cell.size());
    for (const int c : cell) above.push_back(sample_of[c]);
    under_.push_back(sort_into_buckets(above, levels_[l].size()));
    for (std::size_t k = 0; l == 1 && k < cell.size(); ++k) {
      if (above[k] < 0) continue;
      finest_.n[k] = (levels_[0].n[k] + levels_[1].n[above[k]]).normalized();
    }
    if (l + 1 < kLevels) {
      for (int& c : cell) c = pyramid.parents(l)[c];
    }
  }
}

}  // namespace quadrille
