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

std::vector<std::uint8_t> fill_gaps(std::vector<float>& depth, int width,
                                    const Eigen::Vector2d& pitch, const GapRules& rules) {
  std::vector<float> filled(depth.size(), 0.0f);
  const int height = width > 0 ? static_cast<int>(depth.size() / width) : 0;
  for (int v = 0; v < height; ++v) {
    each_gap(depth, static_cast<std::size_t>(v) * width, width, 1, [&](const Gap& gap) {
      if (rules.thin > 0.0) fill_narrow(gap, pitch.x(), rules.thin, filled);
      if (rules.baseline > 0.0) fill_blind(gap, pitch.x(), rules.baseline, filled);
    });
  }
  for (int u = 0; u < width && rules.thin > 0.0; ++u) {
    each_gap(depth, u, height, width,
             [&](const Gap& gap) { fill_narrow(gap, pitch.y(), rules.thin, filled); });
  }
  std::vector<std::uint8_t> mask(depth.size(), 0);
  for (std::size_t n = 0; n < depth.size(); ++n) {
    if (filled[n] == 0.0f) continue;
    depth[n] = filled[n];
    mask[n] = 1;
  }
  return mask;
}

}  // namespace quadrille
