#include "samples/convex_pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "samples/flood.hpp"

namespace quadrille {
namespace {

// Samples that are bent inwards more than this belong to a crease [1/m]. Of values from 3 to 50,
// those about 12 divide the things in simulated bins best. The insides of mugs and bowls are bent
// as much; they stay with the rim around them.
constexpr double kMaxConcavity = 12.0;
// Fewer samples between creases are scraps, not pieces.
constexpr std::size_t kMinPiece = 15;

/// Returns how much the surface at a sample bends inwards: the mean, over the open neighbours, of
/// the curvature towards them where it is concave [1/m].
double concavity(const SurfaceSamples& samples, const Mask& open, int i) {
  double sum = 0.0;
  int count = 0;
  for (const int j : samples.neighbours_of(i)) {
    if (!open[j]) continue;
    const Eigen::Vector3d step = (samples.p[j] - samples.p[i]).cast<double>();
    const Eigen::Vector3d turn = (samples.n[j] - samples.n[i]).cast<double>();
    ++count;
    if (step.isZero()) continue;
    sum += std::max(0.0, -turn.dot(step) / step.squaredNorm());
  }
  return count > 0 ? sum / count : 0.0;
}

void sort_by_size(std::vector<std::vector<int>>* pieces) {
  std::stable_sort(pieces->begin(), pieces->end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
}

/// Takes a connected piece out of the open samples.
std::vector<int> take_piece(const SurfaceSamples& samples, int seed, Mask* open) {
  (*open)[seed] = 0;
  return flood(samples, {seed}, [&](int j, int) {
    const bool joins = (*open)[j] != 0;
    (*open)[j] = 0;
    return joins;
  });
}

/// Gives the samples that are left to the pieces that they touch, ring by ring.
void grow(const SurfaceSamples& samples, std::vector<std::vector<int>>* pieces, Mask* left) {
  std::vector<std::size_t> grown(pieces->size(), 0);
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t n = 0; n < pieces->size(); ++n) {
      std::vector<int>& piece = (*pieces)[n];
      const std::size_t ring = piece.size();
      for (; grown[n] < ring; ++grown[n]) {
        for (const int j : samples.neighbours_of(piece[grown[n]])) {
          if (!(*left)[j]) continue;
          (*left)[j] = 0;
          piece.push_back(j);
          grows = true;
        }
      }
    }
  }
}

}  // namespace

std::vector<std::vector<int>> connected_pieces(const SurfaceSamples& samples, Mask open) {
  std::vector<std::vector<int>> pieces;
  for (int seed = 0; seed < samples.size(); ++seed) {
    if (open[seed]) pieces.push_back(take_piece(samples, seed, &open));
  }
  sort_by_size(&pieces);
  return pieces;
}

std::vector<std::vector<int>> convex_pieces(const SurfaceSamples& samples,
                                            const std::vector<int>& connected) {
  Mask left(samples.size(), 0), convex = left;
  for (const int i : connected) left[i] = 1;
  for (const int i : connected) convex[i] = concavity(samples, left, i) <= kMaxConcavity;
  std::vector<std::vector<int>> pieces;
  for (const int seed : connected) {
    if (!convex[seed]) continue;
    std::vector<int> piece = take_piece(samples, seed, &convex);
    if (piece.size() < kMinPiece) continue;
    for (const int i : piece) left[i] = 0;
    pieces.push_back(std::move(piece));
  }
  if (pieces.empty()) return {connected};
  grow(samples, &pieces, &left);
  sort_by_size(&pieces);
  return pieces;
}

}  // namespace quadrille
