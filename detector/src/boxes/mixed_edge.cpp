#include "boxes/mixed_edge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

/// True if a point that may be mixed floats between a face and what lies behind.
bool has_floating(const Row& row, double behind, double tolerance, double pitch) {
  return std::any_of(row.beside.begin(), row.beside.end(), [&](const Beside& point) {
    const double share = point.height / behind;
    return point.distance <= kMaxMixed * pitch && point.height <= -tolerance && share > kFloating &&
           share < 1.0 - kFloating;
  });
}

/// The place beside a row of points at which the heights pass the middle between the face and what
/// lies behind it.
struct Crossing {
  /// How far beyond half a pitch after the end of the row [m].
  double reach = 0.0;
  /// The range in which it may lie [m].
  double range = 0.0;
};

/// The crossing lies in the middle between the last point above it and the first below. If these
/// are farther apart than pixels are mixed, the sensor lost those between, and only the last point
/// counts.
Crossing crossing_of(const Row& row, double behind, double tolerance, double pitch) {
  double last = 0.0, next = std::numeric_limits<double>::infinity();
  for (const Beside& point : row.beside) {
    const bool may_be_mixed = point.distance <= kMaxMixed * pitch && point.height <= -tolerance;
    if (may_be_mixed && point.height > 0.5 * behind) last = std::max(last, point.distance);
  }
  for (const Beside& point : row.beside) {
    const bool is_beyond = point.distance > last && point.height <= 0.5 * behind;
    if (is_beyond) next = std::min(next, point.distance);
  }
  const double gap = next - last;
  if (gap < kMaxMixed * pitch) return {0.5 * (last + next - pitch), gap};
  return {last, kMaxMixed * pitch};
}

}  // namespace

MixedPixels mixed_pixels(const Rows& rows, double tolerance, double pitch) {
  MixedPixels found;
  std::vector<double> reaches, ranges;
  for (const Row& row : rows.all()) {
    if (row.empty() || !row.seen) continue;
    const std::optional<double> behind = height_behind(row, pitch);
    if (!behind || *behind > -std::max(kMinGap, kMinTolerances * tolerance)) continue;
    const Crossing crossing = crossing_of(row, *behind, tolerance, pitch);
    reaches.push_back(crossing.reach);
    ranges.push_back(crossing.range);
    found.mixed += has_floating(row, *behind, tolerance, pitch);
  }
  found.rows = static_cast<int>(reaches.size());
  if (reaches.empty()) return found;
  found.reach = median(reaches);
  for (double& other : reaches) other -= found.reach;
  // All rows lose their pixels on the same side, so their number does not make the range smaller.
  found.std = std::hypot(robust_std(reaches) / std::sqrt(static_cast<double>(found.rows)),
                         median(ranges) / std::sqrt(12.0));
  return found;
}

}  // namespace quadrille
