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

/// Calls visit(n) for each place of a row where one value is missing and the other was measured.
template <class Visitor>
void each_end(const float* missing, const float* measured, int count, Visitor&& visit) {
  // Most places are not, so that many are looked at together.
  constexpr int kTogether = 16;
  for (int first = 0; first < count; first += kTogether) {
    const int end = std::min(first + kTogether, count);
    int found = 0;
    for (int n = first; n < end; ++n) found |= (missing[n] == 0.0f) & (measured[n] != 0.0f);
    for (int n = first; found != 0 && n < end; ++n) {
      if (missing[n] == 0.0f && measured[n] != 0.0f) visit(n);
    }
  }
}

/// Calls visit(gap) for the gap that ends before a measured pixel, unless it reaches to the edge of
/// the image.
/// @param end  the pixel, which is number `number` of its row or column
template <class Visitor>
void visit_gap_before(const DepthImage& image, std::size_t end, int number, std::size_t stride,
                      Visitor&& visit) {
  const float* after = image.depth.data() + end;
  const float* before = after;
  int length = -1;
  do {
    before -= stride;
    ++length;
  } while (length < number - 1 && *before == 0.0f);
  if (*before != 0.0f) {
    visit(Gap{end - static_cast<std::size_t>(length) * stride, length, stride, *before, *after});
  }
}

/// Calls visit(gap) for each gap in a row of pixels, the first of which is at `start`.
template <class Visitor>
void each_gap_along(const DepthImage& image, std::size_t start, Visitor&& visit) {
  const float* row = image.depth.data() + start;
  each_end(row, row + 1, image.width - 1,
           [&](int n) { visit_gap_before(image, start + n + 1, n + 1, 1, visit); });
}

/// Calls visit(gap) for each gap in the columns of an image. The image is passed row by row, as it
/// lies in memory.
template <class Visitor>
void each_gap_across(const DepthImage& image, Visitor&& visit) {
  const auto stride = static_cast<std::size_t>(image.width);
  for (int v = 1; v < image.height; ++v) {
    const float* row = image.depth.data() + image.index(0, v);
    each_end(row - stride, row, image.width,
             [&](int u) { visit_gap_before(image, image.index(u, v), v, stride, visit); });
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
