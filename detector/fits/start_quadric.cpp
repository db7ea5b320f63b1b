#include "fits/start_quadric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fits/compact_fit.hpp"
#include "fits/tangent_fit.hpp"
#include "fits/taubin_fit.hpp"

namespace quadrille {
namespace {

/// The negative log likelihood per point up to constants, for one Gaussian distance and two
/// Gaussian angles.
double cost(const Quadric& Q, const OrientedPointsd& points) {
  double distance = 1e-20, angle = 1e-20;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d g = Q.gradient(points.points.col(i));
    const double d = std::min(1.0, std::abs(Q.distance(points.points.col(i))));
    distance += d * d;
    angle += (g.normalized() - points.normals.col(i)).squaredNorm();
  }
  return 0.5 * std::log(distance) + std::log(angle);
}

}  // namespace

std::optional<Quadric> start_quadric(const OrientedPointsd& points) {
  std::optional<Quadric> best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const std::optional<Quadric>& Q) {
    if (!Q) return;
    const double c = cost(*Q, points);
    if (c < least) least = c, best = Q;
  };
  offer(fit_taubin(points));
  for (const double weight : {1.0, 0.2}) offer(fit_tangent(points, {weight}));
  for (const double weight : {1.0, 0.2}) offer(fit_compact(points, {weight}));
  return best;
}

}  // namespace quadrille
