#include "surfaces/hidden_ends.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// Samples within this many cells of an end are moved along the axis to this many cells beyond it.
constexpr double kEndCells = 2.0;
// If something is seen this many cells nearer than the surface would be, it stands in front of the
// surface and does not support it.
constexpr double kInFrontCells = 6.0;

enum class Sighting { kHidden, kSeen, kUnknown };

/// Tells what the sensor saw in the direction of a point that a longer surface would reach.
Sighting look_at(const Sight& sight, const Eigen::Vector3d& p_V, double in_front) {
  if (!(p_V.z() > 0.0)) return Sighting::kHidden;
  const double i = std::floor((p_V.x() / p_V.z() - sight.corner.x()) / sight.step);
  const double j = std::floor((p_V.y() / p_V.z() - sight.corner.y()) / sight.step);
  if (!(i >= 0 && j >= 0 && i < sight.width && j < sight.height)) return Sighting::kHidden;
  const float w = sight.w[static_cast<std::size_t>(j) * static_cast<std::size_t>(sight.width) +
                          static_cast<std::size_t>(i)];
  if (w == 0.0f) return Sighting::kUnknown;
  return p_V.z() - 1.0 / w > in_front ? Sighting::kHidden : Sighting::kSeen;
}

/// True if a view sees no end of a surface there: of the samples near the end, most would be hidden
/// if they lay beyond it.
bool is_hidden(const Sight& sight, const SurfaceSamples& samples, std::span<const int> region,
               const Eigen::Isometry3d& X_CQ, double end, double outwards) {
  const Eigen::Isometry3d X_VQ = sight.X_VC.cast<double>() * X_CQ, X_QC = X_CQ.inverse();
  int hidden = 0, seen = 0;
  for (const int i : region) {
    Eigen::Vector3d p_Q = X_QC * samples.raw[i].cast<double>();
    const double reach = kEndCells * static_cast<double>(samples.cell[i]);
    if (std::abs(p_Q.z() - end) > reach) continue;
    p_Q.z() = end + outwards * reach;
    const Sighting sighting =
        look_at(sight, X_VQ * p_Q, kInFrontCells * static_cast<double>(samples.cell[i]));
    hidden += sighting == Sighting::kHidden;
    seen += sighting == Sighting::kSeen;
  }
  return hidden > seen;
}

}  // namespace

bool hides_an_end(std::span<const Sight> sights, const SurfaceSamples& samples,
                  std::span<const int> region, const Eigen::Isometry3d& X_CQ,
                  const Eigen::AlignedBox3d& extent_Q) {
  const auto is_open = [&](double end) {
    const double outwards = end < extent_Q.center().z() ? -1.0 : 1.0;
    return !sights.empty() && std::all_of(sights.begin(), sights.end(), [&](const Sight& sight) {
      return !sight.w.empty() && is_hidden(sight, samples, region, X_CQ, end, outwards);
    });
  };
  return is_open(extent_Q.min().z()) || is_open(extent_Q.max().z());
}

}  // namespace quadrille
