#include "surfaces/lid_outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "base/quantile.hpp"

namespace quadrille {
namespace {

// A point lies on the lid within this many deviations of the points' noise.
constexpr double kMaxSigmas = 3.0;
// Width of a sector at the outline, and the largest gap between the lid and what is seen beside it,
// in distances between points; edges cost a depth image a pixel or two.
constexpr double kSectorPitches = 2.0, kMaxGapPitches = 4.0;
// The lid's points may end this many cells beyond its cells.
constexpr double kBeyondCells = 3.0;
// So many points tell how far behind the lid things are beside it, and a point belongs to these if
// it is at least this share as far behind; others are mixed of both.
constexpr std::size_t kBehindPoints = 5;
constexpr double kBehindShare = 0.93;
// Least sine of the elevation of the eye over a lid (10°); lower, gaps between rows hide its edges.
constexpr double kMinSine = 0.17;
// Least number of points on a lid whose outline is sought.
constexpr std::size_t kMinPoints = 40;

/// A point of the cloud seen through the lid's plane.
struct Seen {
  Eigen::Vector2d on_L;
  /// Distance of that place from the middle, and height of the point over the plane [m].
  double radius, height;
};

/// An edge of the lid in its plane, and the gap between the points beside it [m].
struct Edge {
  Eigen::Vector2d on_L;
  double gap;
};

/// The number of points from the middle of a sector outwards that leaves the fewest points on the
/// wrong side: points behind the lid among them, or points on the lid beyond.
std::size_t best_cut(const std::vector<Seen>& sector, double tolerance) {
  int wrong = 0, least = 0;
  std::size_t cut = 0;
  for (std::size_t k = 0; k < sector.size(); ++k) {
    const double height = sector[k].height;
    wrong += height < -tolerance ? 1 : height <= tolerance ? -1 : 0;
    if (wrong < least) least = wrong, cut = k + 1;
  }
  return cut;
}

/// The edge of the lid in a sector; nullopt if it is not seen.
std::optional<Edge> edge_in(std::vector<Seen> sector, double tolerance, double max_gap) {
  std::sort(sector.begin(), sector.end(),
            [](const Seen& a, const Seen& b) { return a.radius < b.radius; });
  const std::size_t cut = best_cut(sector, tolerance);
  if (cut == 0) return std::nullopt;
  // The cut is the first of the best, so the point before it lies on the lid.
  const Seen& last = sector[cut - 1];
  std::vector<double> behind;
  for (std::size_t k = cut; k < sector.size() && behind.size() < kBehindPoints; ++k) {
    if (sector[k].height < -tolerance) behind.push_back(sector[k].height);
  }
  if (behind.size() < kBehindPoints) return std::nullopt;
  const double well_behind = kBehindShare * median(behind);
  for (std::size_t k = cut; k < sector.size(); ++k) {
    const Seen& next = sector[k];
    const double gap = next.radius - last.radius;
    if (next.height > tolerance || gap > max_gap) return std::nullopt;
    if (next.height > well_behind) continue;
    return Edge{0.5 * (last.on_L + next.on_L), gap};
  }
  return std::nullopt;
}

}  // namespace

std::vector<OutlinePoint> outline_of(const Lid& lid, std::span<const Eigen::Vector3d> points_C,
                                     const Eigen::Vector3d& eye_C) {
  const Eigen::Isometry3d X_LC = lid.X_CL.inverse();
  const Eigen::Vector3d eye = X_LC * eye_C;
  const double sine = eye.z() / eye.norm();
  if (!(sine > kMinSine)) return {};
  double reach = 0.0;
  for (const Eigen::Vector3d& p : lid.places_C) {
    reach = std::max(reach, (X_LC * p).head<2>().norm());
  }
  reach += kBeyondCells * lid.cell;
  std::vector<Seen> seen;
  std::vector<double> heights;
  for (const Eigen::Vector3d& p_C : points_C) {
    const Eigen::Vector3d p = X_LC * p_C;
    if (!(p.z() < 0.5 * eye.z())) continue;
    const double t = eye.z() / (eye.z() - p.z());
    const Eigen::Vector2d on = eye.head<2>() + t * (p - eye).head<2>();
    const double radius = on.norm();
    if (!(radius < reach)) continue;
    seen.push_back({on, radius, p.z()});
    if (radius < 0.5 * reach && std::abs(p.z()) < lid.cell) heights.push_back(p.z());
  }
  if (heights.size() < kMinPoints) return {};
  const double pitch = 0.5 * reach * std::sqrt(std::numbers::pi / double(heights.size()));
  const double tolerance = kMaxSigmas * robust_std(heights);
  const double max_gap = kMaxGapPitches * pitch / std::sqrt(sine);
  const int count = static_cast<int>(2.0 * std::numbers::pi * reach / (kSectorPitches * pitch));
  std::vector<std::vector<Seen>> sectors(static_cast<std::size_t>(std::max(8, count)));
  for (const Seen& s : seen) {
    const double turn = std::atan2(s.on_L.y(), s.on_L.x()) / (2.0 * std::numbers::pi) + 0.5;
    const auto k = static_cast<std::size_t>(turn * static_cast<double>(sectors.size()));
    sectors[std::min(k, sectors.size() - 1)].push_back(s);
  }
  std::vector<OutlinePoint> outline;
  for (std::vector<Seen>& sector : sectors) {
    const auto edge = edge_in(std::move(sector), tolerance, max_gap);
    if (!edge || (eye.head<2>() - edge->on_L).dot(edge->on_L) > 0.0) continue;
    const Eigen::Vector3d on_L(edge->on_L.x(), edge->on_L.y(), 0.0);
    // The edge may lie anywhere within the gap, with equal chance, which has this deviation.
    outline.push_back({lid.X_CL * on_L, edge->gap / std::sqrt(12.0)});
  }
  return outline;
}

}  // namespace quadrille
