#include "boxes/mixed_edge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/quantile.hpp"

namespace quadrille {
namespace {

// Matchers of blocks mix the pixels within two of an outline, so that five in a row may be mixed.
constexpr double kMaxMixed = 5.0;
// Two points tell the height of what lies behind: at oblique faces, whose pitches are stretched,
// not many lie between the mixed pixels and the end of what is looked at.
constexpr std::size_t kMinBehind = 2;
// The points behind a face are of one surface if their heights spread by less than this share of
// the distance from the face.
constexpr double kMaxSpread = 0.25;
// Points float if they lie farther from the face, and from what lies behind, than this share of the
// gap: the spread of either surface reaches about as far.
constexpr double kFloating = 0.15;
// Points in a smaller gap may be those of the face's own rounded edge [m], or noise.
constexpr double kMinGap = 0.012;
constexpr double kMinTolerances = 4.0;

/// Height of the surface that was seen behind the end of a row, from the points beyond those that
/// may be mixed; nullopt if there are too few, or if they lie at several heights.
std::optional<double> height_behind(const Row& row, double pitch) {
  std::vector<double> heights;
  for (const Beside& point : row.beside) {
    if (point.distance > kMaxMixed * pitch) heights.push_back(point.height);
  }
  if (heights.size() < kMinBehind) return std::nullopt;
  const double middle = median(heights);
  const double spread = quantile(heights, 0.8) - quantile(heights, 0.2);
  return spread < -kMaxSpread * middle ? std::optional(middle) : std::nullopt;
}

}  // namespace

MixedPixels mixed_pixels(const Rows& rows, double tolerance, double pitch) {
  MixedPixels found;
  std::vector<double> reaches;
  for (const Row& row : rows.all()) {
    if (row.empty() || !row.seen) continue;
    const std::optional<double> behind = height_behind(row, pitch);
    if (!behind || *behind > -std::max(kMinGap, kMinTolerances * tolerance)) continue;
    double reach = 0.0;
    bool floats = false;
    for (const Beside& point : row.beside) {
      if (point.distance > kMaxMixed * pitch || point.height > -tolerance) continue;
      const double share = point.height / *behind;
      if (share < 0.5) reach = std::max(reach, point.distance);
      floats = floats || (share > kFloating && share < 1.0 - kFloating);
    }
    reaches.push_back(reach);
    found.mixed += floats;
  }
  found.rows = static_cast<int>(reaches.size());
  if (reaches.empty()) return found;
  found.reach = median(reaches);
  for (double& other : reaches) other -= found.reach;
  // Each reach is that of a point, so that the crossing lies within a pitch beyond it.
  const double each = std::hypot(robust_std(reaches), pitch / std::sqrt(12.0));
  found.std = each / std::sqrt(static_cast<double>(found.rows));
  return found;
}

}  // namespace quadrille
