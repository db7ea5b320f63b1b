#include "quadrille/detector/model_selection.hpp"

#include <algorithm>
#include <cmath>

#include "quadrille/detector/initial_fits.hpp"

namespace quadrille {
namespace {

/// Starts for one family; `known` are the fits so far, on which some build.
std::vector<PosedQuadric> starts(const FitPoints& points, Family family,
                                 const std::vector<FamilyFit>& known) {
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
      add(initial_plane(points));
      break;
    case Family::kSphere:
      add(initial_sphere(points));
      break;
    case Family::kCylinder:
      add(initial_cylinder(points));
      if (const auto round = initial_revolution(points)) add(tangent_cylinder(*round));
      break;
    case Family::kCone:
      add(initial_cone(points));
      if (const auto round = initial_revolution(points)) add(tangent_cone(*round));
      break;
    case Family::kRevolution:
      add(initial_revolution(points));
      add_known(Family::kCone, same);
      break;
    case Family::kParaboloid:
      add_known(Family::kRevolution, [](const PosedQuadric& q) { return initial_paraboloid(q); });
      break;
    case Family::kEllipticCylinder:
      add_known(Family::kCylinder, [](const PosedQuadric& q) {
        PosedQuadric unit = q;
        unit.D /= -q.D(3, 3);
        return std::optional(unit);
      });
      break;
    case Family::kGeneral:
      add(initial_general(points));
      break;
  }
  return list;
}

double effective_size(int size, const SelectionOptions& options) {
  return std::max(2.0, options.effective_share * size);
}

/// The inverse of bic(): the sum of squares with which a fit reaches it.
double rss_for(double bic, int size, int dof, const SelectionOptions& options) {
  const double n = effective_size(size, options);
  return size * std::exp((bic - dof * std::log(n)) / n);
}

}  // namespace

double bic(double rss, int size, int dof, const SelectionOptions& options) {
  const double n = effective_size(size, options);
  const double variance = rss / size + 1e-18;
  return n * std::log(variance) + dof * std::log(n);
}

std::optional<FamilyFit> fit_family(const FitPoints& points, Family family,
                                    const std::vector<FamilyFit>& known, int iterations,
                                    double wanted) {
  const PosedQuadric* best = nullptr;
  double least = 0.0;
  const std::vector<PosedQuadric> list = starts(points, family, known);
  for (const PosedQuadric& start : list) {
    const double rss = sum_of_squares(points, start.matrix());
    if (!best || rss < least) best = &start, least = rss;
  }
  if (!best) return std::nullopt;
  return refine(points, family, *best, iterations, wanted);
}

Selection select_family(const FitPoints& points, std::span<const Family> families,
                        const FamilyFit& general, const SelectionOptions& options) {
  const int size = static_cast<int>(points.size());
  Selection selection;
  selection.best = general;
  selection.bic = bic(general.rss, size, family_spec(Family::kGeneral).dof, options);
  selection.fits.push_back(general);
  for (const Family family : families) {
    // Even with the residual of the general fit, this family could not become the best.
    const int dof = family_spec(family).dof;
    if (bic(0.95 * general.rss, size, dof, options) >= selection.bic) continue;
    const double wanted = rss_for(selection.bic, size, dof, options);
    std::optional<FamilyFit> fit =
        fit_family(points, family, selection.fits, options.iterations, wanted);
    if (!fit) continue;
    const double value = bic(fit->rss, size, dof, options);
    if (value < selection.bic) {
      selection.best = *fit;
      selection.bic = value;
    }
    selection.fits.push_back(std::move(*fit));
  }
  return selection;
}

}  // namespace quadrille
