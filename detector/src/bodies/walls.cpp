#include "bodies/walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/quantile.hpp"
#include "bodies/axial_part.hpp"
#include "bodies/profile.hpp"
#include "surfaces/uncertainty.hpp"

namespace quadrille {
namespace {

// Number of heights at which the distance between both sides is measured.
constexpr int kHeights = 9;
// Share of the samples cut off at each end of a side, so that stray samples do not stretch it.
constexpr double kTrimmed = 0.02;
// The two sides overlap along the axis by this share of the shorter one at least. Outside and
// inside of a vessel that stands in a row of others are seldom seen at the same height, but the
// inside is seen up to the rim, as the outside is.
constexpr double kMinOverlap = 0.1;
// A wall is at most so thick, as a share of its outer radius. What stands in a vessel has a larger
// distance from it.
constexpr double kThickest = 0.25;

/// One side of a wall.
struct Side {
  int number;
  const Surface& surface;
  AxialPart part;
  /// True if it has an axis, unlike a sphere.
  bool has_axis() const { return !part.axis_C.isZero(); }
  /// The axis along which its heights count; a sphere takes that of the other side.
  Eigen::Vector3d axis_beside(const Side& other) const {
    return own_axis(has_axis() ? surface : other.surface);
  }
};

/// Heights along an axis, of which C is the origin.
struct Range {
  double low, high;
};

/// Range of a side's samples along an axis.
Range range_along(const Surface& surface, const SurfaceSamples& samples,
                  const Eigen::Vector3d& axis_C) {
  std::vector<double> heights;
  heights.reserve(surface.region.size());
  for (const int i : surface.region) heights.push_back(axis_C.dot(samples.raw[i].cast<double>()));
  const auto trim = static_cast<std::size_t>(kTrimmed * static_cast<double>(heights.size()));
  const double low = nth_smallest(heights, trim);
  return {low, nth_smallest(heights, heights.size() - 1 - trim)};
}

/// Heights at which a wall is measured, over the middles of the outer and of the inner side.
std::vector<std::pair<double, double>> common_heights(const Side& outer, const Side& inner,
                                                      const SurfaceSamples& samples) {
  // Two spheres about one centre are equally far apart everywhere.
  if (!outer.has_axis() && !inner.has_axis()) return {{0.0, 0.0}};
  const Side& main = outer.has_axis() ? outer : inner;
  const Eigen::Vector3d z_C = main.part.axis_C;
  const Range a = range_along(outer.surface, samples, z_C);
  const Range b = range_along(inner.surface, samples, z_C);
  const double low = std::max(a.low, b.low), high = std::min(a.high, b.high);
  if (!(high - low > kMinOverlap * std::min(a.high - a.low, b.high - b.low))) return {};
  std::vector<std::pair<double, double>> heights;
  for (int k = 0; k < kHeights; ++k) {
    const double at = low + (high - low) * k / (kHeights - 1);
    const Eigen::Vector3d p_C = main.part.middle_C + (at - z_C.dot(main.part.middle_C)) * z_C;
    heights.emplace_back(height_in(outer.surface, p_C, outer.axis_beside(inner)),
                         height_in(inner.surface, p_C, inner.axis_beside(outer)));
  }
  return heights;
}

/// The distance between two sides; nullopt if they do not overlap.
/// @param between  covariance of the parameters of both, if they have any
std::optional<WallGap> gap_between(const Side& outer, const Side& inner,
                                   const SurfaceSamples& samples,
                                   const std::optional<Eigen::MatrixXd>& between) {
  const double unit_a = outer.surface.local.scale, unit_b = inner.surface.local.scale;
  std::vector<Place> next_to_a, next_to_b;
  for (const auto& [z_a, z_b] : common_heights(outer, inner, samples)) {
    const auto r_a = radius_at(outer.surface.fit.posed.D, z_a);
    const auto r_b = radius_at(inner.surface.fit.posed.D, z_b);
    if (!r_a || !r_b) continue;
    const double middle = 0.5 * (unit_a * *r_a + unit_b * *r_b);
    next_to_a.push_back({middle / unit_a, z_a});
    next_to_b.push_back({middle / unit_b, z_b});
  }
  if (next_to_a.empty()) return std::nullopt;
  const MeanDistance a = mean_distance(outer.surface, next_to_a, outer.axis_beside(inner));
  const MeanDistance b = mean_distance(inner.surface, next_to_b, inner.axis_beside(outer));
  double variance = a.derivative.dot(parameter_covariance(outer.surface) * a.derivative) +
                    b.derivative.dot(parameter_covariance(inner.surface) * b.derivative);
  if (between) variance -= 2.0 * a.derivative.dot(*between * b.derivative);
  const double offset =
      std::hypot(a.derivative.dot(offset_step(outer.surface)) * offset_std(outer.surface, samples),
                 b.derivative.dot(offset_step(inner.surface)) * offset_std(inner.surface, samples));
  return WallGap{outer.number,      inner.number,
                 b.value - a.value, std::hypot(std::sqrt(std::max(0.0, variance)), offset),
                 -a.derivative,     b.derivative};
}

}  // namespace

std::vector<WallGap> find_gaps(std::span<const Detection> detections,
                               const std::vector<LastFit>& fits, const SurfaceSamples& samples,
                               std::span<const CommonAxis> axes) {
  std::vector<std::pair<int, AxialPart>> outside, inside;
  for (std::size_t k = 0; k < detections.size(); ++k) {
    if (!is_turned(fits[k])) continue;
    const std::optional<AxialPart> part = axial_part(detections[k]);
    if (!part) continue;
    (shows_inside(detections[k]) ? inside : outside).emplace_back(static_cast<int>(k), *part);
  }
  std::vector<WallGap> gaps;
  for (const auto& [a, part_a] : outside) {
    for (const auto& [b, part_b] : inside) {
      if (!share_axis(part_a, part_b)) continue;
      std::optional<WallGap> gap =
          gap_between({a, fits[a].surface, part_a}, {b, fits[b].surface, part_b}, samples,
                      parameter_covariance(a, b, axes));
      if (!gap || gap->thickness > kThickest * part_a.radius) continue;
      gaps.push_back(std::move(*gap));
    }
  }
  return gaps;
}

std::vector<SeenWall> seen_walls(std::span<const WallGap> gaps) {
  std::vector<SeenWall> walls;
  for (const WallGap& gap : gaps) {
    if (!(gap.thickness > gap.std)) continue;
    walls.push_back({gap.outer, gap.inner, BodyWall{gap.thickness, gap.std}});
  }
  return walls;
}

}  // namespace quadrille
