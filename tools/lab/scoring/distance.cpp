#include "lab/scoring/distance.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::scoring {
namespace {

/// Moves a point onto a quadric near it, by steps along the gradient.
Eigen::Vector3d on_surface(const Quadric& Q, Eigen::Vector3d x) {
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d g = Q.gradient(x);
    if (g.squaredNorm() > 0.0) x -= Q.value(x) / g.squaredNorm() * g;
  }
  return x;
}

}  // namespace

double least_distance(const TrueSurface& surface, const std::vector<Eigen::Vector3f>& points,
                      const std::vector<Found>& findings) {
  if (findings.empty()) return surface.size;
  std::vector<double> sums(findings.size(), 0.0);
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3d x = on_surface(surface.Q_C, p.cast<double>());
    for (std::size_t k = 0; k < findings.size(); ++k) {
      const double distance = std::abs(findings[k].value(x)) / findings[k].gradient(x).norm();
      // The comparison is false if the gradient vanishes.
      sums[k] += distance < surface.size ? distance : surface.size;
    }
  }
  return *std::min_element(sums.begin(), sums.end()) / static_cast<double>(points.size());
}

}  // namespace quadrille::scoring
