#include "view/gaps.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

// Number of pixels that a sensor's matching window loses on either side of an edge.
constexpr double kLostAtEdges = 3.0;

/// A run of missing pixels between two measured ones; its pixels are `stride` apart in memory.
struct Gap {
  std::size_t first;
  int length;
  std::size_t stride;
  double before, after;  // depths at its ends
};

/// Calls visit(gap) for each gap in a line of pixels.
template <class Visitor>
void each_gap(const std::vector<float>& depth, std::size_t start, int count, std::size_t stride,
              Visitor&& visit) {
  int seen = -1;  // index of the last measured pixel
  for (int n = 0; n < count; ++n) {
    const float z = depth[start + n * stride];
    if (z == 0.0f) continue;
    if (seen >= 0 && n > seen + 1) {
      visit(
          Gap{start + (seen + 1) * stride, n - seen - 1, stride, depth[start + seen * stride], z});
    }
    seen = n;
  }
}

void raise(float& depth, double z) { depth = std::max(depth, static_cast<float>(z)); }

void fill_narrow(const Gap& gap, double pitch, double thin, std::vector<float>& filled) {
  const double z = std::min({thin / (gap.length * pitch), gap.before, gap.after});
  for (int k = 0; k < gap.length; ++k) raise(filled[gap.first + k * gap.stride], z);
}

void fill_blind(const Gap& gap, double pitch, double baseline, std::vector<float>& filled) {
  const double before = 1.0 / gap.before, after = 1.0 / gap.after;
  if ((gap.length - kLostAtEdges) * pitch > baseline * std::abs(before - after)) return;
  for (int k = 0; k < gap.length; ++k) {
    const double t = (k + 1.0) / (gap.length + 1.0);
    raise(filled[gap.first + k * gap.stride], 1.0 / ((1.0 - t) * before + t * after));
  }
}

}  // namespace

DepthImage fill_gaps(const DepthImage& image, const Eigen::Vector2d& pitch, const GapRules& rules) {
  DepthImage filled = image;
  for (int v = 0; v < image.height; ++v) {
    each_gap(image.depth, image.index(0, v), image.width, 1, [&](const Gap& gap) {
      if (rules.thin > 0.0) fill_narrow(gap, pitch.x(), rules.thin, filled.depth);
      if (rules.baseline > 0.0) fill_blind(gap, pitch.x(), rules.baseline, filled.depth);
    });
  }
  for (int u = 0; u < image.width && rules.thin > 0.0; ++u) {
    each_gap(image.depth, image.index(u, 0), image.height, image.width,
             [&](const Gap& gap) { fill_narrow(gap, pitch.y(), rules.thin, filled.depth); });
  }
  return filled;
}

}  // namespace quadrille
