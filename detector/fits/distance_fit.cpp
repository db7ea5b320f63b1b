#include "fits/distance_fit.hpp"

#include <limits>

#include "fit/geometric_fit.hpp"
#include "fits/normalise.hpp"
#include "fits/projection.hpp"
#include "fits/refine_quadric.hpp"
#include "fits/start_quadric.hpp"

namespace quadrille {
namespace {

// Gains below this share of the residual are rounding errors.
constexpr double kMinGain = 1e-10;

std::optional<NormalEquations> orthogonal_distances(const OrientedPointsd& points,
                                                    const Quadric& Q) {
  NormalEquations sums;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d x = points.points.col(i);
    auto foot = project_nearby(Q, x);
    if (!foot) foot = project(Q, x);
    if (!foot) return std::nullopt;
    const Eigen::Vector3d g = Q.gradient(*foot);
    const double slope = g.norm(), distance = (x - *foot).norm();
    // At an apex the gradient vanishes, and the surface does not move to first order.
    if (!(slope > 1e-9)) {
      sums.cost += distance * distance;
      continue;
    }
    sums.add(monomials(*foot) / slope, (x - *foot).dot(g) < 0 ? -distance : distance);
  }
  return sums;
}

/// Normalises the points and refines the best closed-form fit; if that fails, returns the
/// closed-form fit.
template <typename Refine>
std::optional<Quadric> refine_from_start(const OrientedPointsd& points, const Refine& refine_from) {
  const auto normalised = normalise(points, 9, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const auto start = start_quadric(normalised->data);
  if (!start) return std::nullopt;
  return normalised->undo(refine_from(normalised->data, *start).value_or(*start));
}

}  // namespace

std::optional<Quadric> fit_first_order_distance(const OrientedPointsd& points,
                                                const DistanceFitOptions& options) {
  const auto refined = [&](const OrientedPointsd& data,
                           const Quadric& start) -> std::optional<Quadric> {
    PosedQuadric general;
    general.D = start.matrix() / start.matrix().norm();
    const auto fit = refine(data, Family::kGeneral, general, options.iterations,
                            std::numeric_limits<double>::infinity(), kMinGain);
    if (!fit) return std::nullopt;
    return Quadric(fit->posed.matrix());
  };
  return refine_from_start(points, refined);
}

std::optional<Quadric> fit_orthogonal_distance(const OrientedPointsd& points,
                                               const DistanceFitOptions& options) {
  const auto refined = [&](const OrientedPointsd& data, const Quadric& start) {
    const auto residuals = [&](const Quadric& Q) { return orthogonal_distances(data, Q); };
    return refine_quadric(start, residuals, options.iterations);
  };
  return refine_from_start(points, refined);
}

}  // namespace quadrille
