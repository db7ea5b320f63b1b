#include "surfaces/two_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quadrille {
namespace {

// Number of points that tell how good two lines are; more hardly change which are best.
constexpr std::size_t kLookedAt = 64;
// Least slope of a cone, 9°. The cone next to a cylinder leans more; a tapered cup, less.
constexpr float kLeastSlope = 0.15f;

/// Up to `count` points, spread evenly, each from the middle of its share.
std::vector<MeridianPoint> spread(std::span<const MeridianPoint> points, std::size_t count) {
  count = std::min(count, points.size());
  std::vector<MeridianPoint> some;
  for (std::size_t k = 0; k < count; ++k) {
    some.push_back(points[(2 * k + 1) * points.size() / (2 * count)]);
  }
  return some;
}

}  // namespace

float TwoLines::loss_on_cylinder(const MeridianPoint& p) const {
  return truncated_loss(p.r - radius, p.variance);
}

float TwoLines::loss_on_cone(const MeridianPoint& p) const {
  return truncated_loss(p.r - r0 - slope * p.z, (1.0f + slope * slope) * p.variance);
}

TwoLines two_lines(std::span<const MeridianPoint> points) {
  const std::vector<MeridianPoint> through = spread(points, kLeastProfile);
  const std::vector<MeridianPoint> looked_at = spread(points, kLookedAt);
  std::vector<float> on_cone(looked_at.size());
  TwoLines best;
  for (std::size_t a = 0; a < through.size(); ++a) {
    for (std::size_t b = a + 1; b < through.size(); ++b) {
      TwoLines lines;
      lines.slope = (through[b].r - through[a].r) / (through[b].z - through[a].z);
      if (!std::isfinite(lines.slope) || std::abs(lines.slope) < kLeastSlope) continue;
      lines.r0 = through[a].r - lines.slope * through[a].z;
      std::transform(looked_at.begin(), looked_at.end(), on_cone.begin(),
                     [&](const MeridianPoint& p) { return lines.loss_on_cone(p); });
      for (const MeridianPoint& of_cylinder : through) {
        lines.radius = of_cylinder.r;
        lines.loss = 0.0f;
        for (std::size_t k = 0; k < looked_at.size() && lines.loss < best.loss; ++k) {
          lines.loss += std::min(on_cone[k], lines.loss_on_cylinder(looked_at[k]));
        }
        if (lines.loss < best.loss) best = lines;
      }
    }
  }
  return best;
}

}  // namespace quadrille
