#include "fit/model_selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/closed_form/initial_cone.hpp"
#include "fit/closed_form/initial_cylinder.hpp"
#include "fit/closed_form/initial_general.hpp"
#include "fit/closed_form/initial_plane.hpp"
#include "fit/closed_form/initial_revolution.hpp"
#include "fit/closed_form/initial_sphere.hpp"
#include "fit/closed_form/special_generals.hpp"
#include "fit/closed_form/special_revolutions.hpp"
#include "fit/family_spec.hpp"
#include "fit/normal_equations.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

/// Returns the same surface with its matrix divided by a number.
std::optional<PosedQuadric> divided(PosedQuadric q, double by) {
  q.D /= by;
  return q;
}

/// Closed-form starts for fits to one set of points.
class Starts {
 public:
  explicit Starts(const OrientedPointsf& points) : points_(points) {}

  /// Starts for one family; `known` are the fits so far, on which some starts build.
  std::vector<PosedQuadric> of(Family family, const std::vector<FamilyFit>& known) {
    std::vector<PosedQuadric> list;
    const auto add = [&](const std::optional<PosedQuadric>& start) {
      if (start) list.push_back(*start);
    };
    const auto add_known = [&](Family wanted, auto&& change) {
      for (const FamilyFit& fit : known) {
        if (fit.family == wanted) add(change(fit.posed));
      }
    };
    const auto same = [](const PosedQuadric& q) { return std::optional(q); };
    switch (family) {
      case Family::kPlane:
        add(initial_plane(points_));
        break;
      case Family::kSphere:
        add(initial_sphere(points_));
        break;
      case Family::kCylinder:
        add(initial_cylinder(points_));
        if (revolution()) add(tangent_cylinder(*revolution()));
        break;
      case Family::kCone:
        add(initial_cone(points_));
        if (revolution()) add(tangent_cone(*revolution()));
        break;
      case Family::kRevolution:
        add(revolution());
        add_known(Family::kCone, same);
        break;
      case Family::kParaboloid:
        add_known(Family::kRevolution, initial_paraboloid);
        break;
      case Family::kEllipticCylinder:
        add_known(Family::kGeneral, nearest_cylindrical);
        add_known(Family::kCylinder, [](const auto& q) { return divided(q, -q.D(3, 3)); });
        break;
      case Family::kParabolic:
        add_known(Family::kGeneral, nearest_parabolic);
        add_known(Family::kParaboloid, [](const auto& q) { return divided(q, q.D(2, 3)); });
        break;
      case Family::kGeneral:
        add(initial_general(points_));
        break;
    }
    return list;
  }

 private:
  /// Three families use this start, so it is computed once.
  const std::optional<PosedQuadric>& revolution() {
    if (!revolution_) revolution_ = initial_revolution(points_);
    return *revolution_;
  }

  const OrientedPointsf& points_;
  std::optional<std::optional<PosedQuadric>> revolution_;
};

/// Refines the best of a family's starts.
std::optional<FamilyFit> fit_from(Starts* starts, DistanceSums<float>* points, Family family,
                                  const std::vector<FamilyFit>& known, int iterations,
                                  double wanted) {
  const PosedQuadric* best = nullptr;
  double least = 0.0;
  const std::vector<PosedQuadric> list = starts->of(family, known);
  for (const PosedQuadric& start : list) {
    double rss = 0.0;
    if (list.size() > 1) {
      points->evaluate(start.matrix());
      rss = points->squares();
    }
    if (!best || rss < least) best = &start, least = rss;
  }
  if (!best) return std::nullopt;
  return refine(points, family, *best, iterations, wanted);
}

double effective_size(int size, const SelectionOptions& options) {
  return std::max(2.0, options.effective_share * size);
}

/// The inverse of bic(): the sum of squares at which a fit reaches it.
double rss_for(double bic, int size, int dof, const SelectionOptions& options) {
  const double n = effective_size(size, options);
  const double variance = std::exp((bic - dof * std::log(n)) / n);
  return size * std::max(0.0, variance - options.common_noise * options.common_noise);
}

}  // namespace

double bic(double rss, int size, int dof, const SelectionOptions& options) {
  const double n = effective_size(size, options);
  const double variance = rss / size + options.common_noise * options.common_noise + 1e-18;
  return n * std::log(variance) + dof * std::log(n);
}

double bic(const FamilyFit& fit, const SelectionOptions& options) {
  return bic(fit.rss, fit.points, family_spec(fit.family).dof, options) -
         2.0 * log_prior(canonical_form(fit.posed).type);
}

std::optional<FamilyFit> fit_family(const OrientedPointsf& points, Family family, int iterations) {
  Starts starts(points);
  DistanceSums<float> sums(points);
  return fit_from(&starts, &sums, family, {}, iterations, std::numeric_limits<double>::infinity());
}

Selection select_family(const OrientedPointsf& points, std::span<const Family> families,
                        const FamilyFit& general, const SelectionOptions& options) {
  const int size = static_cast<int>(points.size());
  Starts starts(points);
  DistanceSums<float> sums(points);
  Selection selection;
  selection.best = general;
  selection.bic = bic(general, options);
  selection.fits.push_back(general);
  for (const Family family : families) {
    // The family cannot become the best even with a slightly smaller residual than the general fit,
    // which is not fully converged, so its fit is skipped.
    const int dof = family_spec(family).dof;
    if (bic(0.95 * general.rss, size, dof, options) >= selection.bic) continue;
    const double wanted = rss_for(selection.bic, size, dof, options);
    std::optional<FamilyFit> fit =
        fit_from(&starts, &sums, family, selection.fits, options.iterations, wanted);
    if (!fit) continue;
    const double value = bic(*fit, options);
    if (value < selection.bic) {
      selection.best = *fit;
      selection.bic = value;
    }
    selection.fits.push_back(std::move(*fit));
  }
  return selection;
}

}  // namespace quadrille
