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

struct Sums {
  int n = 0;
  double squares = 0.0;
};

}  // namespace

std::vector<double> rms_of_points(const CloudView& cloud, const CellPyramid& pyramid,
                                  const std::vector<int>& owner,
                                  std::span<const Quadric> quadrics) {
  std::vector<Eigen::Matrix4f> Q;
  Q.reserve(quadrics.size());
  for (const Quadric& quadric : quadrics) Q.push_back(quadric.matrix().cast<float>());
  std::vector<Sums> sums(Q.size());
  const std::size_t step = std::max<std::size_t>(1, cloud.points.size() / kPoints);
  for (std::size_t i = 0; i < cloud.points.size(); i += step) {
    const int cell = pyramid.cell_of(cloud.points[i]);
    if (cell < 0 || owner[cell] < 0) continue;
    const double d = distance_to(Q[owner[cell]], cloud.points[i]);
    if (!std::isfinite(d)) continue;
    Sums& s = sums[owner[cell]];
    ++s.n;
    s.squares += d * d;
  }
  std::vector<double> rms;
  rms.reserve(sums.size());
  for (const Sums& s : sums) {
    rms.push_back(s.n < kMinPoints ? std::numeric_limits<double>::quiet_NaN()
                                   : std::sqrt(s.squares / s.n));
  }
  return rms;
}

}  // namespace quadrille
