#include "surfaces/samples_about.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "samples/flood.hpp"
#include "search/axes/normal_line.hpp"

namespace quadrille {
namespace {

// How far samples may lie beyond either end of the region, as a share of its length.
constexpr float kReach = 0.5f;

/// A sample in the frame of the axis.
struct Place {
  Eigen::Vector3f x, n;

  /// Positive if the normal points away from the axis.
  float outward() const { return n.head<2>().dot(x.head<2>()); }
};

}  // namespace

SamplesAbout samples_about(const Eigen::Isometry3d& X_CA, std::span<const int> region,
                           const SurfaceSamples& samples, const Mask& free) {
  const Eigen::Isometry3f X_AC = X_CA.inverse().cast<float>();
  const auto place = [&](int i) {
    return Place{X_AC * samples.raw[i], X_AC.linear() * samples.n[i]};
  };
  float low = std::numeric_limits<float>::infinity(), high = -low;
  int outside = 0;
  Mask open = free.empty() ? Mask(samples.raw.size(), 1) : free;
  for (const int i : region) {
    const Place at = place(i);
    low = std::min(low, at.x.z()), high = std::max(high, at.x.z());
    outside += at.outward() > 0.0f ? 1 : -1;
    open[i] = 1;
  }
  const float reach = kReach * (high - low);
  low -= reach, high += reach;
  const auto joins = [&](int i, int) {
    if (!open[i]) return false;
    open[i] = 0;
    const Place at = place(i);
    const NormalLine line(at.x, at.n);
    return at.x.z() >= low && at.x.z() <= high && (at.outward() > 0.0f) == (outside > 0) &&
           line.has_direction() && line.meets_axis(samples.cell[i]);
  };
  std::vector<int> start;
  for (const int i : region) {
    if (joins(i, i)) start.push_back(i);
  }
  std::vector<int> all = flood(samples, std::move(start), joins);
  std::sort(all.begin(), all.end());
  return {std::move(all), outside > 0};
}

}  // namespace quadrille
