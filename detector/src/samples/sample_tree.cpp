#include "samples/sample_tree.hpp"

namespace quadrille {

SampleTree::SampleTree(const CellPyramid& pyramid, std::vector<SurfaceSamples> levels)
    : levels_(std::move(levels)), finest_(levels_[0]), first_(kLevels), list_(kLevels) {
  // The finest level is copied, since the search continues with that level's own normals. For each
  // finest sample, `cell` is the cell above it at the current level.
  std::vector<int> cell = levels_[0].source;
  for (int l = 0; l < kLevels; ++l) {
    std::vector<int> sample_of(static_cast<std::size_t>(pyramid.size(l)), -1);
    for (int i = 0; i < levels_[l].size(); ++i) sample_of[levels_[l].source[i]] = i;
    std::vector<int>& first = first_[l];
    first.assign(static_cast<std::size_t>(levels_[l].size()) + 1, 0);
    for (const int c : cell) {
      if (sample_of[c] >= 0) ++first[sample_of[c] + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    list_[l].resize(static_cast<std::size_t>(first.back()));
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const int above = sample_of[cell[k]];
      if (above < 0) continue;
      list_[l][next[above]++] = static_cast<int>(k);
      if (l == 1) finest_.n[k] = (levels_[0].n[k] + levels_[1].n[above]).normalized();
    }
    if (l + 1 < kLevels) {
      for (int& c : cell) c = pyramid.parents(l)[c];
    }
  }
}

std::span<const int> SampleTree::under(int l, int i) const {
  return {list_[l].data() + first_[l][i],
          static_cast<std::size_t>(first_[l][i + 1] - first_[l][i])};
}

}  // namespace quadrille
