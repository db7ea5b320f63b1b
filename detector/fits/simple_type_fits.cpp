#include "fits/simple_type_fits.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "fits/axis.hpp"
#include "fits/fit_scatter.hpp"
#include "fits/type_design.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// The designs hold in the frame of the data, so types are exact up to rounding.
constexpr double kSimpleTypeTolerance = 1e-8;
// Candidates whose coefficients differ less are one surface to rounding.
constexpr double kSame = 1e-6;

QuadricType type_of(const Quadric& Q) { return canonical_form(Q, kSimpleTypeTolerance).type; }

bool is_spheroid(const Quadric& Q) {
  return type_of(Q) == QuadricType::kEllipsoid || type_of(Q) == QuadricType::kSphere;
}

std::optional<Quadric> fit_checked(const NormalisedPoints& points, const Design& B, double weight,
                                   QuadricType type) {
  const auto Q = fit_design(points.data, B, weight);
  if (!Q || type_of(*Q) != type) return std::nullopt;
  return points.undo(*Q);
}

bool are_same(const Quadric& a, const Quadric& b) {
  const Vector10d p = a.normalized().coefficients(), q = b.normalized().coefficients();
  return std::min((p - q).norm(), (p + q).norm()) < kSame;
}

/// The candidate that fits the points best, if no other fits them as well to rounding.
std::optional<Quadric> best_of(const std::vector<Quadric>& candidates, const Scatter& scatter,
                               double weight) {
  std::optional<Quadric> best;
  double least = std::numeric_limits<double>::infinity(), next = least;
  for (const Quadric& Q : candidates) {
    const double misfit = mean_misfit(scatter, Q, weight);
    const bool same = best && are_same(Q, *best);
    if (misfit < least) {
      if (!same) next = least;
      least = misfit, best = Q;
    } else if (!same) {
      next = std::min(next, misfit);
    }
  }
  if (next < kExactMisfit) return std::nullopt;
  return best;
}

}  // namespace

std::optional<Quadric> fit_plane(const OrientedPointsd& points, const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 3, Spread::kPlane);
  if (!normalised) return std::nullopt;
  return fit_checked(*normalised, plane_design(), options.weight, QuadricType::kPlane);
}

std::optional<Quadric> fit_sphere(const OrientedPointsd& points, const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 2, Spread::kLine);
  if (!normalised) return std::nullopt;
  return fit_checked(*normalised, sphere_design(), options.weight, QuadricType::kSphere);
}

std::optional<Quadric> fit_spheroid(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const Scatter scatter(normalised->data);
  std::vector<Quadric> candidates;
  for (const Eigen::Vector3d& axis : directions_of_revolution(normalised->data)) {
    const auto Q = fit_design(scatter, spheroid_design(axis), options.weight);
    if (Q && is_spheroid(*Q)) candidates.push_back(*Q);
  }
  if (candidates.empty()) {
    // Every line through a sphere's centre is an axis. Other points leave the axis open.
    const auto Q = fit_design(scatter, sphere_design(), options.weight);
    if (!Q || type_of(*Q) != QuadricType::kSphere) return std::nullopt;
    if (mean_misfit(scatter, *Q, options.weight) > kExactMisfit) return std::nullopt;
    return normalised->undo(*Q);
  }
  const auto best = best_of(candidates, scatter, options.weight);
  if (!best) return std::nullopt;
  return normalised->undo(*best);
}

std::optional<Quadric> fit_cylinder(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 2, Spread::kLine);
  if (!normalised) return std::nullopt;
  const auto axis = direction_across_normals(normalised->data);
  if (!axis) return std::nullopt;
  return fit_checked(*normalised, cylinder_design(*axis), options.weight, QuadricType::kCylinder);
}

std::optional<Quadric> fit_cone(const OrientedPointsd& points, const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 3, Spread::kPlane);
  if (!normalised) return std::nullopt;
  const auto apex = common_point_of_planes(normalised->data);
  if (!apex || !(apex->norm() < 1e3)) return std::nullopt;
  const Scatter scatter(normalised->data);
  std::vector<Quadric> candidates;
  for (const Eigen::Vector3d& axis : cone_axes(normalised->data, *apex)) {
    const auto Q = fit_design(scatter, cone_design(*apex, axis), options.weight);
    if (Q && type_of(*Q) == QuadricType::kCone) candidates.push_back(*Q);
  }
  const auto best = best_of(candidates, scatter, options.weight);
  if (!best) return std::nullopt;
  return normalised->undo(*best);
}

}  // namespace quadrille
