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

/// Calls visit(gap) for each gap in a row of pixels, the first of which is at `start`.
template <class Visitor>
void each_gap_along(const DepthImage& image, std::size_t start, Visitor&& visit) {
  const float* row = &image.depth[start];
  int seen = -1;  // index of the last measured pixel
  for (int n = 0; n < image.width; ++n) {
    if (row[n] == 0.0f) continue;
    if (seen >= 0 && n > seen + 1) {
      visit(Gap{start + seen + 1, n - seen - 1, 1, row[seen], row[n]});
    }
    seen = n;
  }
}

/// Calls visit(gap) for each gap in the columns of an image. The image is passed row by row, as it
/// lies in memory.
template <class Visitor>
void each_gap_across(const DepthImage& image, Visitor&& visit) {
  const auto stride = static_cast<std::size_t>(image.width);
  std::vector<int> seen(stride, -1);  // row of the last measured pixel of each column
  for (int v = 0; v < image.height; ++v) {
    const float* row = &image.depth[image.index(0, v)];
    int* last = seen.data();
    for (int u = 0; u < image.width; ++u) {
      if (row[u] == 0.0f) continue;
      if (last[u] >= 0 && v > last[u] + 1) {
        visit(Gap{image.index(u, last[u] + 1), v - last[u] - 1, stride, image.at(u, last[u]),
                  row[u]});
      }
      last[u] = v;
    }
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
    each_gap_along(image, image.index(0, v), [&](const Gap& gap) {
      if (rules.thin > 0.0) fill_narrow(gap, pitch.x(), rules.thin, filled.depth);
      if (rules.baseline > 0.0) fill_blind(gap, pitch.x(), rules.baseline, filled.depth);
    });
  }
  if (rules.thin > 0.0) {
    each_gap_across(image,
                    [&](const Gap& gap) { fill_narrow(gap, pitch.y(), rules.thin, filled.depth); });
  }
  return filled;
}

}  // namespace quadrille
