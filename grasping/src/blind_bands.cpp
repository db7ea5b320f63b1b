#include "blind_bands.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

// Pixels that the matching window of a sensor loses on either side of an edge.
constexpr double kLostAtEdges = 3.0;

// Fills row[first, last) if its width is explained; both neighbours are measured.
bool fill_gap(float* row, int first, int last, double pitch, double baseline) {
  const double before = 1.0 / row[first - 1], after = 1.0 / row[last];
  const double parallax = baseline * std::abs(before - after);
  if ((last - first) * pitch > parallax + kLostAtEdges * pitch) return false;
  for (int u = first; u < last; ++u) {
    const double t = static_cast<double>(u - first + 1) / (last - first + 1);
    row[u] = static_cast<float>(1.0 / ((1.0 - t) * before + t * after));
  }
  return true;
}

}  // namespace

std::vector<std::uint8_t> fill_blind_bands(std::vector<float>& depth, int width, double pitch,
                                           double baseline) {
  std::vector<std::uint8_t> filled(depth.size(), 0);
  if (baseline <= 0.0 || width < 3) return filled;
  for (std::size_t start = 0; start < depth.size(); start += width) {
    float* row = &depth[start];
    int seen = -1;  // the last measured pixel
    for (int u = 0; u < width; ++u) {
      if (row[u] == 0.0F) continue;
      if (seen >= 0 && u > seen + 1 && fill_gap(row, seen + 1, u, pitch, baseline)) {
        std::fill(filled.begin() + static_cast<std::ptrdiff_t>(start) + seen + 1,
                  filled.begin() + static_cast<std::ptrdiff_t>(start) + u, 1);
      }
      seen = u;
    }
  }
  return filled;
}

}  // namespace quadrille
