#include "fits/distance_fit.hpp"

#include <algorithm>
#include <cmath>

#include "fits/projection.hpp"
#include "fits/refine_quadric.hpp"
#include "fits/start_quadric.hpp"

namespace quadrille {
namespace {

// Where the gradient is weaker than this share of its root mean square, the first-order distance
// is cut: near an apex or a centre it would explode.
constexpr double kWeakGradient = 0.05;

std::optional<NormalEquations> first_order_distances(const OrientedPoints& points,
                                                     const Quadric& Q) {
  NormalEquations sums;
  double mean = 0.0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    mean += Q.gradient(points.points.col(i)).squaredNorm() / static_cast<double>(points.size());
  }
  const double least = kWeakGradient * std::sqrt(mean);
  if (!(least > 0.0)) return std::nullopt;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d x = points.points.col(i), g = Q.gradient(x);
    const double slope = std::max(g.norm(), least), residual = Q.value(x) / slope;
    const Vector10d change = monomial_gradients(x).transpose() * g / slope;
    sums.add((monomials(x) - residual * change) / slope, residual);
  }
  return sums;
}

std::optional<NormalEquations> orthogonal_distances(const OrientedPoints& points,
                                                    const Quadric& Q) {
  NormalEquations sums;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d x = points.points.col(i);
    auto foot = project_nearby(Q, x);
    if (!foot) foot = project(Q, x);
    if (!foot) return std::nullopt;
    const Eigen::Vector3d g = Q.gradient(*foot);
    const double slope = g.norm(), distance = (x - *foot).norm();
    // At an apex the surface stays where it is in the first order.
    if (!(slope > 1e-9)) {
      sums.cost += distance * distance;
      continue;
    }
    sums.add(monomials(*foot) / slope, (x - *foot).dot(g) < 0 ? -distance : distance);
  }
  return sums;
}

template <typename Distances>
std::optional<Quadric> fit_distance(const OrientedPoints& points, int iterations,
                                    const Distances& distances) {
  const auto normalised = normalise(points, 9, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const auto start = start_quadric(normalised->data);
  if (!start) return std::nullopt;
  const auto Q = refine_quadric(
      *start, [&](const Quadric& at) { return distances(normalised->data, at); }, iterations);
  return normalised->undo(Q.value_or(*start));
}

}  // namespace

std::optional<Quadric> fit_first_order_distance(const OrientedPoints& points,
                                                const DistanceFitOptions& options) {
  return fit_distance(points, options.iterations, first_order_distances);
}

std::optional<Quadric> fit_orthogonal_distance(const OrientedPoints& points,
                                               const DistanceFitOptions& options) {
  return fit_distance(points, options.iterations, orthogonal_distances);
}

}  // namespace quadrille
