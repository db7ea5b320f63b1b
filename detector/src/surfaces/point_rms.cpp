#include "surfaces/point_rms.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "samples/inliers.hpp"

namespace quadrille {
namespace {

// Approximate number of points that are looked at, and least number per quadric, which determines
// its rms to about 15 %.
constexpr std::size_t kPoints = 10'000;
constexpr int kMinPoints = 20;

}  // namespace

PointRms::PointRms(std::span<const Quadric> quadrics) : sums_(quadrics.size()) {
  Q_.reserve(quadrics.size());
  for (const Quadric& quadric : quadrics) Q_.push_back(quadric.matrix().cast<float>());
}

void PointRms::add(const CloudView& cloud, const CellPyramid& pyramid, std::span<const int> owner) {
  const std::size_t step = std::max<std::size_t>(1, cloud.points.size() / kPoints);
  pyramid.visit_points(cloud, step, owner, [&](std::size_t i, int cell) {
    const double d = distance_to(Q_[owner[cell]], cloud.points[i]);
    if (!std::isfinite(d)) return;
    Sums& s = sums_[owner[cell]];
    ++s.n;
    s.squares += d * d;
  });
}

std::vector<double> PointRms::values() const {
  std::vector<double> rms;
  rms.reserve(sums_.size());
  for (const Sums& s : sums_) {
    rms.push_back(s.n < kMinPoints ? std::numeric_limits<double>::quiet_NaN()
                                   : std::sqrt(s.squares / s.n));
  }
  return rms;
}

}  // namespace quadrille
